#include "ros2/controllers/diff_drive_controller/diff_drive_controller.hh"

#include <algorithm>
#include <utility>

#include "ros2/robot/stamps.hh"

namespace pongsim::ros2 {

Outcome<void> DiffDriveController::configure(const ControllerSetup& setup) {
  ControllerParameters& parameters = setup.parameters;
  left_ = parameters.texts("left_wheel_names");
  right_ = parameters.texts("right_wheel_names");
  if (left_.empty() || left_.size() != right_.size()) {
    parameters.complain("'left_wheel_names' and 'right_wheel_names' must have the same number of joints, at least one");
  }
  const double radius = parameters.numberAboveZero("wheel_radius", 0);
  separation_ = parameters.numberAboveZero("wheel_separation", 0) * parameters.number("wheel_separation_multiplier", 1);
  leftRadius_ = radius * parameters.number("left_wheel_radius_multiplier", 1);
  rightRadius_ = radius * parameters.number("right_wheel_radius_multiplier", 1);
  isOpenLoop_ = parameters.flag("open_loop", false);
  readsPositions_ = parameters.flag("position_feedback", true);
  // what it was for has been the number of names ever since Humble
  parameters.ignore("wheels_per_side");
  timeout_ = fromSeconds(std::max(0.0, parameters.number("cmd_vel_timeout", 0.5)));
  const auto window = std::max<std::int64_t>(1, parameters.whole("velocity_rolling_window_size", 10));
  odometry_ = WheelOdometry(static_cast<std::size_t>(window));
  linearLimiter_ = RateLimiter(RateLimits::read(parameters, "linear.x"));
  angularLimiter_ = RateLimiter(RateLimits::read(parameters, "angular.z"));
  publishing_ = Schedule(periodOf(parameters.numberAboveZero("publish_rate", 50)));
  frames_ = setup.frames;
  output_.configure(setup, {.odometryTopic = "~/odom", .transformTopic = "/tf", .hasPrefix = true});
  if (parameters.flag("publish_limited_velocity", false)) {
    limited_ = setup.advertise<geometry_msgs::TwistStamped>("~/cmd_vel_out");
  }
  // Humble's; later ones take stamped velocities alone
  const bool isStamped = !parameters.has("use_stamped_vel") || parameters.flag("use_stamped_vel", true);
  input_.configure(setup, isStamped ? "~/cmd_vel" : "~/cmd_vel_unstamped", timeout_, isStamped);
  return {};
}

Controller::Interfaces DiffDriveController::interfaces() const {
  Interfaces wanted;
  for (const auto* side : {&left_, &right_}) {
    for (const std::string& wheel : *side) {
      wanted.commands.push_back(wheel + "/velocity");
      if (!isOpenLoop_) wanted.states.push_back(wheel + (readsPositions_ ? "/position" : "/velocity"));
    }
  }
  return wanted;
}

Outcome<void> DiffDriveController::activate(const Loan& loan, Time) {
  loan_ = loan;
  input_.enable(true);
  begin();
  return {};
}

void DiffDriveController::begin() {
  last_ = beforeLast_ = {};
  if (isOpenLoop_ || !readsPositions_) return;
  leftDistance_ = mean(0) * leftRadius_;
  rightDistance_ = mean(left_.size()) * rightRadius_;
}

void DiffDriveController::deactivate() {
  loan_ = {};
  input_.enable(false);
}

/// @return Zero before the first command and when it has timed out.
DiffDriveController::Speeds DiffDriveController::wanted(Time now) const {
  const auto& command = input_.command();
  if (!command || (timeout_ > Time::zero() && now - command->stamp > timeout_)) return {};
  return {command->linear, command->angular};
}

void DiffDriveController::update(Time now, double period) {
  const Speeds wanted = this->wanted(now);
  const Speeds speeds{linearLimiter_.limit(wanted.linear, last_.linear, beforeLast_.linear, period),
                      angularLimiter_.limit(wanted.angular, last_.angular, beforeLast_.angular, period)};
  beforeLast_ = last_;
  last_ = speeds;
  updateOdometry(period, speeds);
  if (publishing_.isDue(now)) output_.publish(odometry_, now);
  if (limited_ && limited_->hasReaders()) {
    geometry_msgs::TwistStamped message;
    message.header.stamp = stampOf(now, frames_);
    message.twist.linear.x = speeds.linear;
    message.twist.angular.z = speeds.angular;
    limited_->publish(message);
  }
  const double turn = speeds.angular * separation_ / 2;
  for (std::size_t i = 0; i < loan_.commands.size(); ++i) {
    const bool isLeft = i < left_.size();
    loan_.commands[i]->set(isLeft ? (speeds.linear - turn) / leftRadius_ : (speeds.linear + turn) / rightRadius_);
  }
}

/// @return The mean of one side.
double DiffDriveController::mean(std::size_t firstState) const {
  double sum = 0;
  for (std::size_t i = 0; i < left_.size(); ++i) sum += loan_.states[firstState + i]->read();
  return sum / static_cast<double>(left_.size());
}

void DiffDriveController::updateOdometry(double period, const Speeds& commanded) {
  if (isOpenLoop_) {
    odometry_.advance(commanded.linear, commanded.angular, period);
    odometry_.setVelocities(commanded.linear, 0, commanded.angular);
    return;
  }
  double left = mean(0) * leftRadius_, right = mean(left_.size()) * rightRadius_;
  if (readsPositions_) {
    left = (left - std::exchange(leftDistance_, left)) / period;
    right = (right - std::exchange(rightDistance_, right)) / period;
  }
  const double linear = (left + right) / 2, angular = (right - left) / separation_;
  odometry_.advance(linear, angular, period);
  odometry_.average(linear, angular);
}

void DiffDriveController::reset() {
  odometry_.reset();
  publishing_.reset();
  input_.clear();
  begin();
}

void DiffDriveController::transfer(StateArchive& archive) {
  archive(publishing_);
  archive(odometry_);
  archive(input_);
  archive(last_);
  archive(beforeLast_);
  archive(leftDistance_);
  archive(rightDistance_);
}

}  // namespace pongsim::ros2
