#include "ros2/controllers/steering_controllers/steering_controller.hh"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "pongsim/math.hh"
#include "ros2/robot/stamps.hh"

namespace pongsim::ros2 {

namespace {

/// @return Those of a name of Humble, where they are given, else those of the present name.
std::vector<std::string> jointNames(ControllerParameters& parameters, const char* name, const std::string& older) {
  const std::vector<std::string> named = parameters.texts(older);
  const std::vector<std::string> current = parameters.texts(name);
  return named.empty() ? current : named;
}

}  // namespace

void SteeringController::readWheels(ControllerParameters& parameters) {
  const bool steersFront = parameters.flag("front_steering", true);
  const std::string front = "front_wheels", rear = "rear_wheels";
  const std::string& traction = steersFront ? rear : front;
  const std::string& steering = steersFront ? front : rear;
  traction_ = jointNames(parameters, "traction_joints_names", traction + "_names");
  steering_ = jointNames(parameters, "steering_joints_names", steering + "_names");
  tractionStates_ = jointNames(parameters, "traction_joints_state_names", traction + "_state_names");
  steeringStates_ = jointNames(parameters, "steering_joints_state_names", steering + "_state_names");
  const std::size_t tractionCount = kind_ == Kind::kBicycle ? 1 : 2, steeringCount = kind_ == Kind::kAckermann ? 2 : 1;
  if (traction_.size() != tractionCount) {
    parameters.complain("'traction_joints_names' must have " + std::to_string(tractionCount) + " joints");
  }
  if (steering_.size() != steeringCount) {
    parameters.complain("'steering_joints_names' must have " + std::to_string(steeringCount) + " joints");
  }
  if (tractionStates_.empty()) tractionStates_ = traction_;
  if (steeringStates_.empty()) steeringStates_ = steering_;
  if (tractionStates_.size() != traction_.size() || steeringStates_.size() != steering_.size()) {
    parameters.complain("there must be as many joints to read as to command");
  }
  kinematics_.tractionWheels = static_cast<int>(tractionCount);
  kinematics_.steeredWheels = static_cast<int>(steeringCount);
  readKinematics(parameters, steersFront);
}

void SteeringController::readKinematics(ControllerParameters& parameters, bool steersFront) {
  kinematics_.wheelbase = parameters.numberAboveZero("wheelbase", 0);
  // those of Humble, with front and rear in their names, precede
  const auto first = [&](std::initializer_list<const char*> names) {
    double value = 0;
    for (const char* name : names) {
      const double given = parameters.number(name, 0);
      if (value <= 0) value = given;
    }
    return value;
  };
  kinematics_.wheelRadius = steersFront
                                ? first({"rear_wheels_radius", "rear_wheel_radius", "front_wheels_radius",
                                         "front_wheel_radius", "traction_wheels_radius", "traction_wheel_radius"})
                                : first({"front_wheels_radius", "front_wheel_radius", "rear_wheels_radius",
                                         "rear_wheel_radius", "traction_wheels_radius", "traction_wheel_radius"});
  if (!(kinematics_.wheelRadius > 0)) parameters.complain("'traction_wheels_radius' must be above zero");
  if (kind_ == Kind::kBicycle) return;
  if (kind_ == Kind::kTricycle) {
    kinematics_.tractionTrack = first({"wheel_track", "traction_track_width"});
  } else {
    kinematics_.tractionTrack = steersFront ? first({"rear_wheel_track", "traction_track_width"})
                                            : first({"front_wheel_track", "traction_track_width"});
    kinematics_.steeringTrack = steersFront ? first({"front_wheel_track", "steering_track_width"})
                                            : first({"rear_wheel_track", "steering_track_width"});
  }
  if (!(kinematics_.tractionTrack > 0)) parameters.complain("'traction_track_width' must be above zero");
  if (!(kinematics_.steeringTrack > 0)) kinematics_.steeringTrack = kinematics_.tractionTrack;
}

Outcome<void> SteeringController::configure(const ControllerSetup& setup) {
  ControllerParameters& parameters = setup.parameters;
  readWheels(parameters);
  isOpenLoop_ = parameters.flag("open_loop", false);
  readsPositions_ = parameters.flag("position_feedback", false);
  slowsUntilSteered_ = parameters.flag("reduce_wheel_speed_until_steering_reached", false);
  timeout_ = fromSeconds(std::max(0.0, parameters.number("reference_timeout", 1)));
  const auto window = std::max<std::int64_t>(1, parameters.whole("velocity_rolling_window_size", 10));
  odometry_ = WheelOdometry(static_cast<std::size_t>(window));
  frames_ = setup.frames;
  output_.configure(
      setup, {.odometryTopic = "~/odometry", .transformTopic = "~/tf_odometry", .covariance = {0, 7, 14, 21, 28, 35}});
  state_ = setup.advertise<control_msgs::SteeringControllerStatus>("~/controller_state");
  message_.header.frame_id = frames_.toRos(parameters.text("odom_frame_id", "odom"));
  // Humble's, before it took stamped velocities alone
  const bool isStamped = !parameters.has("use_stamped_vel") || parameters.flag("use_stamped_vel", true);
  input_.configure(setup, isStamped ? "~/reference" : "~/reference_unstamped", timeout_, isStamped);
  return {};
}

Controller::Interfaces SteeringController::interfaces() const {
  Interfaces wanted;
  for (const std::string& joint : traction_) wanted.commands.push_back(joint + "/velocity");
  for (const std::string& joint : steering_) wanted.commands.push_back(joint + "/position");
  for (const std::string& joint : tractionStates_) {
    wanted.states.push_back(joint + (readsPositions_ ? "/position" : "/velocity"));
  }
  for (const std::string& joint : steeringStates_) wanted.states.push_back(joint + "/position");
  return wanted;
}

Outcome<void> SteeringController::activate(const Loan& loan, Time) {
  loan_ = loan;
  input_.enable(true);
  lastPositions_ = states(0, traction_.size());
  return {};
}

void SteeringController::deactivate() {
  loan_ = {};
  input_.enable(false);
}

std::vector<double> SteeringController::states(std::size_t first, std::size_t count) const {
  std::vector<double> values;
  for (std::size_t i = first; i < first + count; ++i) values.push_back(loan_.states[i]->read());
  return values;
}

void SteeringController::updateOdometry(double period, double linear, double angular) {
  if (isOpenLoop_) {
    odometry_.advance(linear, angular, period);
    odometry_.setVelocities(linear, 0, angular);
    steeringAngle_ = kinematics_.steeringAngle(linear, angular);
    return;
  }
  std::vector<double> speeds = states(0, traction_.size());
  if (readsPositions_) {
    const std::vector<double> before = std::exchange(lastPositions_, speeds);
    for (std::size_t i = 0; i < speeds.size(); ++i) speeds[i] = (speeds[i] - before[i]) / period;
  }
  steeringAngle_ = kinematics_.steeringAngle(states(traction_.size(), steering_.size()));
  const double forward = kinematics_.linearVelocity(speeds, steeringAngle_);
  const double turning = kinematics_.angularVelocity(forward, steeringAngle_);
  odometry_.advance(forward, turning, period);
  odometry_.average(forward, turning);
}

void SteeringController::update(Time now, double period) {
  const auto& command = input_.command();
  const bool isOld = command && timeout_ > Time::zero() && now - command->stamp > timeout_;
  const bool isCommanded = command && !isOld;
  const double linear = isCommanded ? command->linear : 0, angular = isCommanded ? command->angular : 0;
  // without a timeout a command is for one update
  if (timeout_ == Time::zero()) input_.clear();
  updateOdometry(period, linear, angular);
  if (isCommanded) {
    SteeringKinematics::Wheels wheels = kinematics_.commands(linear, angular, steeringAngle_);
    if (slowsUntilSteered_ && !isOpenLoop_) {
      constexpr double kNear = std::numbers::pi / 6, kFar = 1.5608;
      const double apart = std::abs(steeringAngle_ - kinematics_.steeringAngle(linear, angular));
      const double scale = apart < kNear ? 1 : math::cos(std::min(apart, kFar)) / math::cos(kNear);
      for (double& speed : wheels.speeds) speed *= scale;
    }
    for (std::size_t i = 0; i < traction_.size(); ++i) loan_.commands[i]->set(wheels.speeds[i]);
    for (std::size_t i = 0; i < steering_.size(); ++i) loan_.commands[traction_.size() + i]->set(wheels.angles[i]);
  } else {
    // it stops, and keeps its steering
    for (std::size_t i = 0; i < traction_.size(); ++i) loan_.commands[i]->set(0);
  }
  output_.publish(odometry_, now);
  publishState(now);
}

void SteeringController::publishState(Time now) {
  if (!state_->hasReaders()) return;
  message_.header.stamp = stampOf(now, frames_);
  auto& traction = readsPositions_ ? message_.traction_wheels_position : message_.traction_wheels_velocity;
  traction = states(0, traction_.size());
  message_.steer_positions = states(traction_.size(), steering_.size());
  message_.linear_velocity_command.clear();
  message_.steering_angle_command.clear();
  for (std::size_t i = 0; i < loan_.commands.size(); ++i) {
    auto& list = i < traction_.size() ? message_.linear_velocity_command : message_.steering_angle_command;
    list.push_back(loan_.commands[i]->get());
  }
  state_->publish(message_);
}

void SteeringController::reset() {
  odometry_.reset();
  input_.clear();
  steeringAngle_ = 0;
  lastPositions_ = states(0, traction_.size());
}

void SteeringController::transfer(StateArchive& archive) {
  archive(odometry_);
  archive(input_);
  archive(steeringAngle_);
  archive(lastPositions_);
  archive.check(lastPositions_.size() == traction_.size());
}

}  // namespace pongsim::ros2
