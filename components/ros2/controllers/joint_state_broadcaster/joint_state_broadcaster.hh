#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "ros2/controllers/controller.hh"
#include "ros2/types/control_msgs.hh"
#include "ros2/types/sensor_msgs.hh"

namespace pongsim::ros2 {

/// Publishes the state interfaces of joints on /joint_states, and all on /dynamic_joint_states.
class JointStateBroadcaster final : public Controller {
 public:
  static constexpr const char* kTypes[] = {"joint_state_broadcaster/JointStateBroadcaster"};

  Outcome<void> configure(const ControllerSetup& setup) override;
  Interfaces interfaces() const override;
  std::vector<std::string> replacedTopics() const override { return {topic_}; }
  Outcome<void> activate(const Loan& loan, Time now) override;
  void deactivate() override;
  void update(Time now, double period) override;
  void reset() override {}
  void transfer(StateArchive&) override {}

 private:
  /// Where a state interface is written to; null: nowhere.
  struct Target {
    const HardwareInterfaces::State* state = nullptr;
    double* plain = nullptr;
    double* dynamic = nullptr;
  };
  void nameJoints(const Loan& loan);

  std::vector<std::string> joints_;
  std::vector<std::string> interfaces_;
  std::vector<std::string> extraJoints_;
  /// Names of interfaces that stand for "position", "velocity" and "effort".
  std::map<std::string, std::string> mapped_;
  /// The robot's joints that move; empty: not known.
  std::vector<std::string> described_;
  Frames frames_;
  std::string topic_;
  std::unique_ptr<RosPublisher> plain_;
  std::unique_ptr<RosPublisher> dynamic_;
  sensor_msgs::JointState message_;
  control_msgs::DynamicJointState dynamicMessage_;
  std::vector<Target> targets_;
};

}  // namespace pongsim::ros2
