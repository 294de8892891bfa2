#include "ros2/controllers/imu_sensor_broadcaster/imu_sensor_broadcaster.hh"

#include <algorithm>

#include "ros2/robot/stamps.hh"

namespace pongsim::ros2 {

Outcome<void> ImuSensorBroadcaster::configure(const ControllerSetup& setup) {
  ControllerParameters& parameters = setup.parameters;
  sensor_ = parameters.text("sensor_name", "");
  if (sensor_.empty()) parameters.complain("'sensor_name' is missing");
  const std::string frame = parameters.text("frame_id", "");
  if (frame.empty()) parameters.complain("'frame_id' is missing");
  frames_ = setup.frames;
  message_.header.frame_id = frames_.toRos(frame);
  const auto readCovariance = [&](const char* name, std::array<double, 9>& covariance) {
    const auto numbers = parameters.numbers(name, std::vector<double>(9, 0.0), 9);
    std::ranges::copy(numbers, covariance.begin());
  };
  readCovariance("static_covariance_orientation", message_.orientation_covariance);
  readCovariance("static_covariance_angular_velocity", message_.angular_velocity_covariance);
  readCovariance("static_covariance_linear_acceleration", message_.linear_acceleration_covariance);
  publisher_ = setup.advertise<sensor_msgs::Imu>("~/imu");
  return {};
}

Controller::Interfaces ImuSensorBroadcaster::interfaces() const {
  Interfaces wanted;
  for (const char* each :
       {"orientation.x", "orientation.y", "orientation.z", "orientation.w", "angular_velocity.x", "angular_velocity.y",
        "angular_velocity.z", "linear_acceleration.x", "linear_acceleration.y", "linear_acceleration.z"}) {
    wanted.states.push_back(sensor_ + "/" + each);
  }
  return wanted;
}

Outcome<void> ImuSensorBroadcaster::activate(const Loan& loan, Time) {
  loan_ = loan;
  return {};
}

void ImuSensorBroadcaster::update(Time now, double) {
  if (!publisher_->hasReaders()) return;
  const auto value = [this](std::size_t i) { return loan_.states[i]->read(); };
  message_.header.stamp = stampOf(now, frames_);
  message_.orientation = {value(0), value(1), value(2), value(3)};
  message_.angular_velocity = {value(4), value(5), value(6)};
  message_.linear_acceleration = {value(7), value(8), value(9)};
  publisher_->publish(message_);
}

}  // namespace pongsim::ros2
