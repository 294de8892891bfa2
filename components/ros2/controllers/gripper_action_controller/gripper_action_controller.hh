#pragma once

#include <memory>
#include <optional>
#include <string>

#include "pongsim/parameters.hh"
#include "ros2/controllers/controller.hh"
#include "ros2/controllers/joint_trajectory_controller/joint_pid.hh"
#include "ros2/node/action.hh"
#include "ros2/types/control_actions.hh"

namespace pongsim::ros2 {

/// Moves a joint to a position by the action `~/gripper_cmd`: GripperCommand for the classes of position_controllers
/// and effort_controllers, ParallelGripperCommand for that of parallel_gripper_action_controller.
class GripperActionController final : public Controller {
 public:
  enum class Kind { kPosition, kEffort, kParallel };
  explicit GripperActionController(Kind kind) : kind_(kind) {}

  Outcome<void> configure(const ControllerSetup& setup) override;
  Interfaces interfaces() const override;
  Outcome<void> activate(const Loan& loan, Time now) override;
  void deactivate() override;
  void update(Time now, double period) override;
  void reset() override;
  void transfer(StateArchive& archive) override;

 private:
  using Gripper = control_msgs::action::GripperCommand;
  using Parallel = control_msgs::action::ParallelGripperCommand;
  using Goal = ActionServer<Gripper>::Id;

  void offer(const ControllerSetup& setup);
  bool accepts(double position) const;
  void begin(const Goal& id, double position, double effort);
  void end(std::int8_t status, bool isStalled, bool isReached);
  void command(double position, double velocity, double period);

  Kind kind_;
  std::string joint_;
  std::string name_;
  const Logger* log_ = nullptr;
  std::function<Time()> now_;
  double tolerance_ = 0;
  double maxEffort_ = 0;
  bool allowsStalling_ = false;
  double stallVelocity_ = 0;
  double stallTimeout_ = 0;
  std::unique_ptr<ActionServer<Gripper>> gripper_;
  std::unique_ptr<ActionServer<Parallel>> parallel_;
  Loan loan_;
  std::optional<Goal> goal_;
  bool isCanceled_ = false;

  JointPid pid_;
  /// Nothing: the position at the next update is held.
  std::optional<double> target_;
  double effort_ = 0;
  double commanded_ = 0;
  Time moved_{0};
};

}  // namespace pongsim::ros2
