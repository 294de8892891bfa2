#include "ros2/controllers/mecanum_drive_controller/mecanum_drive_controller.hh"

#include <algorithm>
#include <utility>

#include "pongsim/math.hh"
#include "ros2/robot/stamps.hh"

namespace pongsim::ros2 {

namespace {
constexpr const char* kWheels[] = {"front_left", "front_right", "rear_right", "rear_left"};
}

Outcome<void> MecanumDriveController::configure(const ControllerSetup& setup) {
  ControllerParameters& parameters = setup.parameters;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::string name = std::string(kWheels[i]) + "_wheel_command_joint_name";
    joints_[i] = parameters.text(name, "");
    if (joints_[i].empty()) parameters.complain("'" + name + "' is missing");
    stateJoints_[i] = parameters.text(std::string(kWheels[i]) + "_wheel_state_joint_name", "");
    if (stateJoints_[i].empty()) stateJoints_[i] = joints_[i];
  }
  radius_ = parameters.numberAboveZero("kinematics.wheels_radius", 0);
  reach_ = parameters.numberAboveZero("kinematics.sum_of_robot_center_projection_on_X_Y_axis", 0);
  offset_ = Vector3(parameters.number("kinematics.base_frame_offset.x", 0),
                    parameters.number("kinematics.base_frame_offset.y", 0),
                    parameters.number("kinematics.base_frame_offset.theta", 0));
  timeout_ = fromSeconds(std::max(0.0, parameters.number("reference_timeout", 0)));
  limiters_ = {RateLimiter(RateLimits::read(parameters, "linear.x")),
               RateLimiter(RateLimits::read(parameters, "linear.y")),
               RateLimiter(RateLimits::read(parameters, "angular.z"))};
  frames_ = setup.frames;
  output_.configure(setup, {.odometryTopic = "~/odometry",
                            .transformTopic = "~/tf_odometry",
                            .covariance = std::vector<double>(6, 0.1),
                            .hasPrefix = true});
  state_ = setup.advertise<control_msgs::MecanumDriveControllerState>("~/controller_state");
  message_.header.frame_id = frames_.toRos(parameters.text("odom_frame_id", "odom"));
  const bool isStamped = !parameters.has("use_stamped_vel") || parameters.flag("use_stamped_vel", true);
  input_.configure(setup, isStamped ? "~/reference" : "~/reference_unstamped", timeout_, isStamped);
  return {};
}

Controller::Interfaces MecanumDriveController::interfaces() const {
  Interfaces wanted;
  for (const std::string& joint : joints_) wanted.commands.push_back(joint + "/velocity");
  for (const std::string& joint : stateJoints_) wanted.states.push_back(joint + "/velocity");
  return wanted;
}

Outcome<void> MecanumDriveController::activate(const Loan& loan, Time) {
  loan_ = loan;
  input_.enable(true);
  last_ = beforeLast_ = {};
  return {};
}

void MecanumDriveController::deactivate() {
  loan_ = {};
  input_.enable(false);
}

/// Velocities of the base frame, from those of the wheels' centre, from those of the wheels.
void MecanumDriveController::updateOdometry(double period) {
  std::array<double, 4> w{};
  for (std::size_t i = 0; i < 4; ++i) w[i] = loan_.states[i]->read() * radius_ / 4;
  const double x = w[0] + w[1] + w[2] + w[3], y = -w[0] + w[1] - w[2] + w[3];
  const double turn = (-w[0] + w[1] + w[2] - w[3]) / reach_;
  const auto [sine, cosine] = math::sinCos(-offset_.z());
  const auto rotate = [&](double a, double b) { return std::pair(cosine * a - sine * b, sine * a + cosine * b); };
  const auto [vx, vy] = rotate(x, y);
  const auto [ox, oy] = rotate(-offset_.x(), -offset_.y());
  const double linear = vx + oy * turn, lateral = vy - ox * turn;
  odometry_.advanceStraight(linear, lateral, turn, period);
  odometry_.setVelocities(linear, lateral, turn);
}

/// Speeds of the wheels for velocities of the base frame, the reverse of the above.
std::array<double, 4> MecanumDriveController::wheelSpeeds(const Speeds& speeds) const {
  const auto [sine, cosine] = math::sinCos(offset_.z());
  const double x = cosine * speeds[0] - sine * speeds[1] + offset_.y() * speeds[2];
  const double y = sine * speeds[0] + cosine * speeds[1] - offset_.x() * speeds[2];
  const double turn = reach_ * speeds[2];
  return {(x - y - turn) / radius_, (x + y + turn) / radius_, (x - y + turn) / radius_, (x + y - turn) / radius_};
}

void MecanumDriveController::update(Time now, double period) {
  updateOdometry(period);
  const auto& command = input_.command();
  const bool isCommanded = command && (timeout_ == Time::zero() || now - command->stamp <= timeout_);
  Speeds wanted{};
  if (isCommanded) wanted = {command->linear, command->lateral, command->angular};
  // without a timeout a command is for one update
  if (timeout_ == Time::zero()) input_.clear();
  Speeds speeds{};
  for (std::size_t i = 0; i < 3; ++i) speeds[i] = limiters_[i].limit(wanted[i], last_[i], beforeLast_[i], period);
  beforeLast_ = last_;
  last_ = speeds;
  const std::array<double, 4> wheels = wheelSpeeds(speeds);
  for (std::size_t i = 0; i < 4; ++i) loan_.commands[i]->set(wheels[i]);
  output_.publish(odometry_, now);
  publishState(now, wanted);
}

void MecanumDriveController::publishState(Time now, const Speeds& wanted) {
  if (!state_->hasReaders()) return;
  message_.header.stamp = stampOf(now, frames_);
  message_.front_left_wheel_velocity = loan_.states[0]->read();
  message_.front_right_wheel_velocity = loan_.states[1]->read();
  message_.back_right_wheel_velocity = loan_.states[2]->read();
  message_.back_left_wheel_velocity = loan_.states[3]->read();
  message_.reference_velocity.linear = {wanted[0], wanted[1], 0};
  message_.reference_velocity.angular = {0, 0, wanted[2]};
  state_->publish(message_);
}

void MecanumDriveController::reset() {
  odometry_.reset();
  input_.clear();
  last_ = beforeLast_ = {};
}

void MecanumDriveController::transfer(StateArchive& archive) {
  archive(odometry_);
  archive(input_);
  for (Speeds* speeds : {&last_, &beforeLast_}) {
    for (double& speed : *speeds) archive(speed);
  }
}

}  // namespace pongsim::ros2
