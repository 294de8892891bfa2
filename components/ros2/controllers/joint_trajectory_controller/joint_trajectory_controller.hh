#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/parameters.hh"
#include "ros2/controllers/controller.hh"
#include "ros2/controllers/joint_trajectory_controller/joint_pid.hh"
#include "ros2/controllers/joint_trajectory_controller/tolerances.hh"
#include "ros2/controllers/joint_trajectory_controller/trajectory.hh"
#include "ros2/controllers/joint_trajectory_controller/trajectory_message.hh"
#include "ros2/node/action.hh"
#include "ros2/types/control_actions.hh"

namespace pongsim::ros2 {

/// Moves joints along trajectories, from the topic `~/joint_trajectory` and the action `~/follow_joint_trajectory`.
class JointTrajectoryController final : public Controller {
 public:
  Outcome<void> configure(const ControllerSetup& setup) override;
  Interfaces interfaces() const override;
  Outcome<void> activate(const Loan& loan, Time now) override;
  void deactivate() override;
  void update(Time now, double period) override;
  void reset() override;
  void transfer(StateArchive& archive) override;

 private:
  using Action = control_msgs::action::FollowJointTrajectory;
  using Goal = ActionServer<Action>::Id;

  void readInterfaces(ControllerParameters& parameters);
  bool commands(const char* interface) const;
  bool reads(const char* interface) const;
  TrajectoryPoint readState() const;
  std::vector<double> heldPositions() const;
  void receive(const trajectory_msgs::JointTrajectory& message);
  bool accepts(const Action::Goal& goal);
  void execute(const Goal& id, const Action::Goal& goal);
  void hold(std::vector<double> positions);
  void endGoal(std::int8_t status, std::int32_t code, const std::string& text);
  TrajectoryPoint errorsOf(const TrajectoryPoint& desired, const TrajectoryPoint& actual) const;
  bool judge(const Trajectory::Sample& next, const TrajectoryPoint& errors, bool isFirst);
  void write(const TrajectoryPoint& next, const TrajectoryPoint& desired, const TrajectoryPoint& errors, double period);
  void publish(Time now, const TrajectoryPoint& desired, const TrajectoryPoint& actual, const TrajectoryPoint& errors);
  void publishState(Time now, const TrajectoryPoint& desired, const TrajectoryPoint& actual,
                    const TrajectoryPoint& errors);

  const Logger* log_ = nullptr;
  std::string name_;
  Frames frames_;
  std::function<Time()> now_;
  TrajectoryRules rules_;
  std::vector<std::string> commandJoints_;
  /// The place of each of them among the joints.
  std::vector<std::size_t> commandPlaces_;
  std::vector<std::string> commandInterfaces_;
  std::vector<std::string> stateInterfaces_;
  std::vector<bool> wraps_;
  bool interpolates_ = true;
  bool fromDesired_ = false;
  bool usesPid_ = false;
  double commandTimeout_ = 0;
  double speedScale_ = 1;
  Time updatePeriod_{0};
  TrajectoryTolerances defaults_;
  std::unique_ptr<RosSubscription> topic_;
  std::unique_ptr<ActionServer<Action>> action_;
  std::unique_ptr<RosPublisher> state_;
  Loan loan_;
  Action::Feedback feedback_;

  Schedule monitoring_;
  std::vector<JointPid> pids_;
  TrajectoryTolerances tolerances_;
  /// Nothing: the positions at the next update are held.
  std::optional<Trajectory> trajectory_;
  bool isHolding_ = true;
  Time trajectoryTime_{0};
  std::optional<TrajectoryPoint> lastCommand_;
  std::optional<Goal> goal_;
  bool isCanceled_ = false;
};

}  // namespace pongsim::ros2
