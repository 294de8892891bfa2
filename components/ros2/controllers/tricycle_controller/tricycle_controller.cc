#include "ros2/controllers/tricycle_controller/tricycle_controller.hh"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include "pongsim/math.hh"
#include "ros2/types/ackermann_msgs.hh"
#include "ros2/types/std_srvs.hh"

namespace pongsim::ros2 {

Outcome<void> TricycleController::configure(const ControllerSetup& setup) {
  ControllerParameters& parameters = setup.parameters;
  tractionJoint_ = parameters.text("traction_joint_name", "");
  steeringJoint_ = parameters.text("steering_joint_name", "");
  if (tractionJoint_.empty()) parameters.complain("'traction_joint_name' is missing");
  if (steeringJoint_.empty()) parameters.complain("'steering_joint_name' is missing");
  wheelbase_ = parameters.numberAboveZero("wheelbase", 0);
  wheelRadius_ = parameters.numberAboveZero("wheel_radius", 0);
  isOpenLoop_ = parameters.flag("open_loop", false);
  tellsPose_ = !parameters.flag("odom_only_twist", false);
  timeout_ =
      std::chrono::milliseconds(std::clamp<std::int64_t>(parameters.whole("cmd_vel_timeout", 500), 0, 1'000'000));
  const auto window = std::max<std::int64_t>(1, parameters.whole("velocity_rolling_window_size", 10));
  odometry_ = WheelOdometry(static_cast<std::size_t>(window));
  tractionLimiter_ = TractionLimiter::read(parameters);
  steeringLimiter_ = SteeringLimiter::read(parameters);
  output_.configure(setup, {.odometryTopic = "~/odom", .transformTopic = "/tf", .tellsTransform = false});
  if (parameters.flag("publish_ackermann_command", false)) {
    ackermann_ = setup.advertise<ackermann_msgs::AckermannDrive>("~/cmd_ackermann");
  }
  resetOdometry_ = serveAtOnce<std_srvs::srv::Empty>(setup.ros, setup.remaps.apply(setup.ros, "~/reset_odometry"),
                                                     [this](const std_srvs::srv::Empty::Request&) {
                                                       odometry_.reset();
                                                       return std_srvs::srv::Empty::Response{};
                                                     });
  const bool isStamped = !parameters.has("use_stamped_vel") || parameters.flag("use_stamped_vel", true);
  // late commands are taken, and time out
  input_.configure(setup, "~/cmd_vel", Time::zero(), isStamped);
  return {};
}

Controller::Interfaces TricycleController::interfaces() const {
  return {.commands = {tractionJoint_ + "/velocity", steeringJoint_ + "/position"},
          .states = {tractionJoint_ + "/velocity", steeringJoint_ + "/position"}};
}

Outcome<void> TricycleController::activate(const Loan& loan, Time) {
  loan_ = loan;
  input_.enable(true);
  last_ = beforeLast_ = {};
  return {};
}

void TricycleController::deactivate() {
  loan_ = {};
  input_.enable(false);
}

/// The wheel's speed and steering angle for velocities of the rear axle's middle.
TricycleController::Axle TricycleController::axleFor(double linear, double angular) const {
  if (linear == 0 && angular != 0) {
    // on the spot
    return {std::abs(angular) * wheelbase_ / wheelRadius_, std::copysign(std::numbers::pi / 2, angular)};
  }
  const double angle = linear == 0 ? 0 : math::atan(angular * wheelbase_ / linear);
  return {linear / (wheelRadius_ * math::cos(angle)), angle};
}

void TricycleController::update(Time now, double period) {
  const auto& command = input_.command();
  const bool isCommanded = command && now - command->stamp <= timeout_;
  const double linear = isCommanded ? command->linear : 0, angular = isCommanded ? command->angular : 0;
  const double speed = loan_.states[0]->read(), angle = loan_.states[1]->read();
  if (isOpenLoop_) {
    odometry_.advance(linear, angular, period);
    odometry_.setVelocities(linear, 0, angular);
  } else {
    const auto [sine, cosine] = math::sinCos(angle);
    const double forward = speed * wheelRadius_ * cosine, turning = speed * wheelRadius_ * sine / wheelbase_;
    odometry_.advance(forward, turning, period);
    odometry_.average(forward, turning);
  }
  output_.publish(odometry_, now, tellsPose_);
  Axle axle = axleFor(linear, angular);
  // slower until the wheel has turned
  const double apart = std::abs(axle.angle - angle);
  constexpr double kNear = std::numbers::pi / 6, kFar = std::numbers::pi / 2;
  if (apart >= kNear) axle.speed *= apart > kFar ? 0.01 : math::cos(apart);
  axle.speed = tractionLimiter_.limit(axle.speed, last_.speed, beforeLast_.speed, period);
  axle.angle = steeringLimiter_.limit(axle.angle, last_.angle, beforeLast_.angle, period);
  beforeLast_ = last_;
  last_ = axle;
  if (ackermann_ && ackermann_->hasReaders()) {
    ackermann_msgs::AckermannDrive message;
    message.speed = static_cast<float>(axle.speed);
    message.steering_angle = static_cast<float>(axle.angle);
    ackermann_->publish(message);
  }
  loan_.commands[0]->set(axle.speed);
  loan_.commands[1]->set(axle.angle);
}

void TricycleController::reset() {
  odometry_.reset();
  input_.clear();
  last_ = beforeLast_ = {};
}

void TricycleController::transfer(StateArchive& archive) {
  archive(odometry_);
  archive(input_);
  archive(last_);
  archive(beforeLast_);
}

}  // namespace pongsim::ros2
