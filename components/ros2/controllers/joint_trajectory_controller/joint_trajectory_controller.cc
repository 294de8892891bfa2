#include "ros2/controllers/joint_trajectory_controller/joint_trajectory_controller.hh"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <utility>

#include "pongsim/files/urdf_source.hh"
#include "ros2/node/stamp.hh"
#include "ros2/robot/stamps.hh"

namespace pongsim::ros2 {

namespace {

using Result = control_msgs::action::FollowJointTrajectory::Result;
using GoalStatus = action_msgs::GoalStatus;

constexpr double kTurn = 2 * std::numbers::pi;

bool includes(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

/// @return Whether the robot's file says that a joint turns without end.
bool isContinuous(const Model& model, const std::string& name) {
  const UrdfSource* urdf = model.urdf();
  if (urdf == nullptr) return false;
  return std::ranges::any_of(urdf->robot.childrenNamed("joint"), [&name](const Element* joint) {
    return joint->attributeOr("name", "") == name && joint->attributeOr("type", "") == "continuous";
  });
}

/// @return The difference of two angles, from -pi to pi.
double shortest(double from, double to) { return std::remainder(to - from, kTurn); }

trajectory_msgs::JointTrajectoryPoint messageOf(const TrajectoryPoint& point) {
  const auto seconds = std::chrono::floor<std::chrono::seconds>(point.time);
  return {point.positions,
          point.velocities,
          point.accelerations,
          point.effort,
          {static_cast<std::int32_t>(seconds.count()), static_cast<std::uint32_t>((point.time - seconds).count())}};
}

}  // namespace

bool JointTrajectoryController::commands(const char* interface) const {
  return includes(commandInterfaces_, interface);
}
bool JointTrajectoryController::reads(const char* interface) const { return includes(stateInterfaces_, interface); }

void JointTrajectoryController::readInterfaces(ControllerParameters& parameters) {
  rules_.joints = parameters.texts("joints");
  if (rules_.joints.empty()) parameters.complain("'joints' is empty");
  commandJoints_ = parameters.texts("command_joints");
  if (commandJoints_.empty()) commandJoints_ = rules_.joints;
  for (const std::string& joint : commandJoints_) {
    const auto place = std::ranges::find(rules_.joints, joint);
    if (place == rules_.joints.end()) {
      parameters.complain("'command_joints' has '" + joint + "', which 'joints' has not");
    } else {
      commandPlaces_.push_back(static_cast<std::size_t>(place - rules_.joints.begin()));
    }
  }
  commandInterfaces_ = parameters.texts("command_interfaces");
  stateInterfaces_ = parameters.texts("state_interfaces");
  for (const std::string& each : commandInterfaces_) {
    if (each == "position" || each == "velocity" || each == "effort") continue;
    parameters.complain("'command_interfaces' has '" + each + "', which is none of position, velocity, effort");
  }
  if (commandInterfaces_.empty()) parameters.complain("'command_interfaces' is empty");
  if (!reads("position")) parameters.complain("'state_interfaces' must have position");
  usesPid_ = commandInterfaces_.size() == 1 && (commands("velocity") || commands("effort"));
  if (usesPid_ && !reads("velocity")) {
    parameters.complain("'state_interfaces' must have velocity where 'command_interfaces' has no position");
  }
}

Outcome<void> JointTrajectoryController::configure(const ControllerSetup& setup) {
  ControllerParameters& parameters = setup.parameters;
  log_ = &setup.log;
  name_ = setup.ros.options().name;
  frames_ = setup.frames;
  now_ = setup.now;
  updatePeriod_ = periodOf(setup.rate);
  readInterfaces(parameters);
  rules_.allowsPartial = parameters.flag("allow_partial_joints_goal", false);
  rules_.allowsIntegration = parameters.flag("allow_integration_in_goal_trajectories", false);
  rules_.allowsVelocityAtEnd = parameters.flag("allow_nonzero_velocity_at_trajectory_end", false);
  rules_.takesEffort = commands("effort");
  const std::string method = parameters.text("interpolation_method", "splines");
  if (method != "splines" && method != "none") parameters.complain("'interpolation_method' must be splines or none");
  interpolates_ = method != "none";
  const bool isOpenLoop = parameters.flag("open_loop_control", false);
  fromDesired_ = parameters.flag("interpolate_from_desired_state", false) || isOpenLoop;
  if (isOpenLoop && commands("velocity")) usesPid_ = false;
  defaults_ = tolerances_ = TrajectoryTolerances::read(parameters, rules_.joints);
  commandTimeout_ = parameters.number("cmd_timeout", 0);
  if (commandTimeout_ > 0 && commandTimeout_ <= defaults_.goalTime) commandTimeout_ = 0;
  speedScale_ = parameters.number("speed_scaling.initial_scaling_factor", 1);
  monitoring_ = Schedule(periodOf(parameters.numberAboveZero("action_monitor_rate", 20)));
  // states are all there is on activation
  parameters.ignore("set_last_command_interface_value_as_state_on_activation");
  for (const std::string& joint : rules_.joints) wraps_.push_back(isContinuous(setup.model, joint));
  for (const std::string& joint : commandJoints_) {
    if (usesPid_) pids_.push_back(JointPid::read(parameters, joint));
  }
  feedback_.joint_names = rules_.joints;
  topic_ = setup.subscribe<trajectory_msgs::JointTrajectory>("~/joint_trajectory",
                                                             [this](const auto& message) { receive(message); });
  action_ = std::make_unique<ActionServer<Action>>(
      setup.ros, setup.remaps.apply(setup.ros, "~/follow_joint_trajectory"), [this] { return stampOf(now_()); },
      ActionServer<Action>::Handlers{[this](const auto& goal) { return accepts(goal); },
                                     [this](const auto& id, const auto& goal) { execute(id, goal); },
                                     [this](const auto& id) { return isCanceled_ = goal_ == id; }});
  // Humble's is another type of the same name, without the speed: its nodes get none
  using State = control_msgs::JointTrajectoryControllerState;
  state_ = setup.ros.advertise<State>(setup.remaps.apply(setup.ros, "~/controller_state"), kDefaultQos, {},
                                      [own = typeInfo<State>().hash](const std::string& hash) { return hash == own; });
  return {};
}

Controller::Interfaces JointTrajectoryController::interfaces() const {
  Interfaces wanted;
  for (const std::string& interface : commandInterfaces_) {
    for (const std::string& joint : commandJoints_) wanted.commands.push_back(joint + "/" + interface);
  }
  for (const std::string& interface : stateInterfaces_) {
    for (const std::string& joint : rules_.joints) wanted.states.push_back(joint + "/" + interface);
  }
  return wanted;
}

Outcome<void> JointTrajectoryController::activate(const Loan& loan, Time) {
  loan_ = loan;
  reset();
  return {};
}

void JointTrajectoryController::deactivate() {
  endGoal(GoalStatus::kStatusAborted, Result::kInvalidGoal, "Current goal cancelled during deactivate transition.");
  loan_ = {};
}

void JointTrajectoryController::reset() {
  endGoal(GoalStatus::kStatusAborted, Result::kInvalidGoal, "the simulation was reset");
  trajectory_.reset();
  lastCommand_.reset();
  isHolding_ = true;
  trajectoryTime_ = Time::zero();
  tolerances_ = defaults_;
  monitoring_.reset();
  for (JointPid& pid : pids_) pid.reset();
}

/// Interfaces that are not read leave their lists empty.
TrajectoryPoint JointTrajectoryController::readState() const {
  TrajectoryPoint state;
  const std::size_t joints = rules_.joints.size();
  for (std::size_t i = 0; i < stateInterfaces_.size(); ++i) {
    auto* list = stateInterfaces_[i] == "position"   ? &state.positions
                 : stateInterfaces_[i] == "velocity" ? &state.velocities
                                                     : nullptr;
    for (std::size_t joint = 0; list != nullptr && joint < joints; ++joint) {
      list->push_back(loan_.states[i * joints + joint]->read());
    }
  }
  return state;
}

std::vector<double> JointTrajectoryController::heldPositions() const {
  return lastCommand_ ? lastCommand_->positions : readState().positions;
}

void JointTrajectoryController::receive(const trajectory_msgs::JointTrajectory& message) {
  if (loan_.commands.empty()) return;
  Outcome<Trajectory> read = readTrajectory(message, rules_, heldPositions(), now_());
  if (!read) return log_->warning("controller '" + name_ + "': a trajectory is refused: " + read.error);
  trajectory_ = std::move(*read);
  isHolding_ = false;
}

bool JointTrajectoryController::accepts(const Action::Goal& goal) {
  std::string why;
  if (loan_.commands.empty()) {
    why = "the controller is not active";
  } else {
    why = readTrajectory(goal.trajectory, rules_, heldPositions(), now_()).error;
  }
  if (!why.empty()) log_->warning("controller '" + name_ + "': a goal is refused: " + why);
  return why.empty();
}

void JointTrajectoryController::execute(const Goal& id, const Action::Goal& goal) {
  endGoal(GoalStatus::kStatusAborted, Result::kInvalidGoal, "Current goal preempted by new incoming action.");
  Outcome<Trajectory> read = readTrajectory(goal.trajectory, rules_, heldPositions(), now_());
  trajectory_ = std::move(*read);
  isHolding_ = false;
  goal_ = id;
  Outcome<TrajectoryTolerances> tolerances = defaults_.withThoseOf(goal, rules_.joints);
  if (!tolerances) {
    log_->warning("controller '" + name_ + "': the tolerances of a goal are not used: " + tolerances.error);
  }
  tolerances_ = tolerances ? std::move(*tolerances) : defaults_;
}

void JointTrajectoryController::hold(std::vector<double> positions) {
  trajectory_ = Trajectory(Time::zero(), {{Time::zero(), std::move(positions)}});
  isHolding_ = true;
}

void JointTrajectoryController::endGoal(std::int8_t status, std::int32_t code, const std::string& text) {
  if (goal_) action_->end(*goal_, status, {code, text});
  goal_.reset();
  isCanceled_ = false;
}

TrajectoryPoint JointTrajectoryController::errorsOf(const TrajectoryPoint& desired,
                                                    const TrajectoryPoint& actual) const {
  TrajectoryPoint errors;
  for (std::size_t i = 0; i < rules_.joints.size(); ++i) {
    errors.positions.push_back(wraps_[i] ? shortest(actual.positions[i], desired.positions[i])
                                         : desired.positions[i] - actual.positions[i]);
    // as with position commands alone velocities lag, theirs are not compared then
    const bool compares = !actual.velocities.empty() && (commands("velocity") || commands("effort"));
    errors.velocities.push_back(compares ? desired.velocities[i] - actual.velocities[i] : 0);
  }
  return errors;
}

void JointTrajectoryController::update(Time now, double period) {
  const TrajectoryPoint actual = readState();
  if (isCanceled_) {
    endGoal(GoalStatus::kStatusCanceled, Result::kSuccessful, "");
    hold(actual.positions);
  }
  if (!trajectory_) hold(actual.positions);
  const bool isFirst = !trajectory_->hasBegun();
  if (isFirst) {
    TrajectoryPoint before = fromDesired_ && lastCommand_ ? *lastCommand_ : actual;
    // the shorter way round to the first point
    for (std::size_t i = 0; i < rules_.joints.size(); ++i) {
      if (!wraps_[i] || trajectory_->points()[0].positions.empty()) continue;
      const double target = trajectory_->points()[0].positions[i];
      before.positions[i] = target - shortest(before.positions[i], target);
    }
    trajectory_->begin(now, std::move(before));
    trajectoryTime_ = now;
  } else {
    trajectoryTime_ += fromSeconds(period * speedScale_);
  }
  Trajectory::Sample desired = trajectory_->sample(trajectoryTime_, interpolates_);
  const Trajectory::Sample next = trajectory_->sample(trajectoryTime_ + updatePeriod_, interpolates_);
  desired.state.time = trajectoryTime_ - trajectory_->start();
  const TrajectoryPoint errors = errorsOf(desired.state, actual);
  if (judge(next, errors, isFirst)) {
    write(next.state, desired.state, errors, period);
    lastCommand_ = next.state;
  }
  // that of the next point, or beyond the last
  feedback_.index = static_cast<std::int32_t>(trajectoryTime_ < trajectory_->timeOf(0) ? 0 : desired.point + 1);
  publish(now, desired.state, actual, errors);
}

/// Ends the trajectory and its goal, when it is reached or a tolerance is violated.
/// @return Whether the tolerances hold, and the next state may be commanded.
bool JointTrajectoryController::judge(const Trajectory::Sample& next, const TrajectoryPoint& errors, bool isFirst) {
  if (isHolding_) {
    // the trajectory of a saved state
    if (goal_) endGoal(GoalStatus::kStatusAborted, Result::kInvalidGoal, "the simulation went back to another state");
    return true;
  }
  const double late = toSeconds(trajectoryTime_ - trajectory_->timeOf(next.point));
  bool leftPath = false, isAtGoal = true;
  for (std::size_t i = 0; i < rules_.joints.size(); ++i) {
    if (!next.isOver || isFirst) leftPath |= !tolerances_.path[i].contains(errors, i);
    if (next.isOver) isAtGoal &= tolerances_.goal[i].contains(errors, i);
  }
  const bool isTooLate = next.isOver && !isAtGoal && tolerances_.goalTime > 0 && late > tolerances_.goalTime;
  if (leftPath) {
    log_->warning("controller '" + name_ + "': a joint left the path's tolerance: it holds its position");
    endGoal(GoalStatus::kStatusAborted, Result::kPathToleranceViolated, "Aborted due to path tolerance violation");
    hold(readState().positions);
  } else if (isTooLate) {
    const std::string text = "Aborted due to goal_time_tolerance exceeding by " + std::to_string(late) + " seconds";
    log_->warning("controller '" + name_ + "': the goal was not reached in time: it holds its position");
    endGoal(GoalStatus::kStatusAborted, Result::kGoalToleranceViolated, text);
    hold(readState().positions);
  } else if (next.isOver && isAtGoal && goal_) {
    endGoal(GoalStatus::kStatusSucceeded, Result::kSuccessful, "Goal successfully reached!");
    hold(next.state.positions);
  } else if (next.isOver && commandTimeout_ > 0 && late > commandTimeout_) {
    log_->warning("controller '" + name_ + "': no new trajectory came in time: it holds its position");
    hold(readState().positions);
  }
  return !leftPath && !isTooLate;
}

void JointTrajectoryController::write(const TrajectoryPoint& next, const TrajectoryPoint& desired,
                                      const TrajectoryPoint& errors, double period) {
  const std::size_t joints = commandJoints_.size();
  for (std::size_t k = 0; k < commandInterfaces_.size(); ++k) {
    for (std::size_t i = 0; i < joints; ++i) {
      const std::size_t place = commandPlaces_[i];
      const std::string& interface = commandInterfaces_[k];
      double value = interface == "position"   ? next.positions[place]
                     : interface == "velocity" ? next.velocities[place]
                                               : desired.effort[place];
      if (usesPid_) {
        const double effort = interface == "effort" ? next.effort[place] : 0;
        value = effort +
                pids_[i].command(errors.positions[place], errors.velocities[place], next.velocities[place], period);
      }
      loan_.commands[k * joints + i]->set(value);
    }
  }
}

void JointTrajectoryController::publish(Time now, const TrajectoryPoint& desired, const TrajectoryPoint& actual,
                                        const TrajectoryPoint& errors) {
  if (state_->hasReaders()) publishState(now, desired, actual, errors);
  if (!goal_ || !monitoring_.isDue(now)) return;
  feedback_.header.stamp = stampOf(now, frames_);
  feedback_.desired = messageOf(desired);
  feedback_.actual = messageOf(actual);
  feedback_.error = messageOf(errors);
  action_->publishFeedback(*goal_, feedback_);
}

void JointTrajectoryController::publishState(Time now, const TrajectoryPoint& desired, const TrajectoryPoint& actual,
                                             const TrajectoryPoint& errors) {
  control_msgs::JointTrajectoryControllerState message;
  message.header.stamp = stampOf(now, frames_);
  message.joint_names = rules_.joints;
  message.reference = messageOf(desired);
  message.reference.effort.clear();
  message.feedback = messageOf(actual);
  message.error = messageOf(errors);
  const std::size_t joints = commandJoints_.size();
  for (std::size_t k = 0; k < commandInterfaces_.size(); ++k) {
    auto* list = commandInterfaces_[k] == "position"   ? &message.output.positions
                 : commandInterfaces_[k] == "velocity" ? &message.output.velocities
                                                       : &message.output.effort;
    for (std::size_t i = 0; i < joints; ++i) list->push_back(loan_.commands[k * joints + i]->get());
  }
  message.speed_scaling_factor = speedScale_;
  state_->publish(message);
}

void JointTrajectoryController::transfer(StateArchive& archive) {
  const std::size_t joints = rules_.joints.size();
  archive(monitoring_);
  archive(isHolding_);
  archive(trajectoryTime_);
  tolerances_.transfer(archive, joints);
  for (JointPid& pid : pids_) archive(pid);
  bool has = trajectory_.has_value();
  archive(has);
  if (archive.isGiving()) has ? void(trajectory_.emplace()) : trajectory_.reset();
  if (trajectory_) trajectory_->transfer(archive, joints);
  archive(lastCommand_);
  archive.check(!lastCommand_ || lastCommand_->positions.size() == joints);
}

}  // namespace pongsim::ros2
