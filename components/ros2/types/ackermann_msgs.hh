#pragma once

#include "ros2/types/reflection.hh"

namespace pongsim::ros2::ackermann_msgs {

struct AckermannDrive {
  static constexpr const char* kName = "ackermann_msgs/msg/AckermannDrive";
  float steering_angle = 0;
  float steering_angle_velocity = 0;
  float speed = 0;
  float acceleration = 0;
  float jerk = 0;
  static void visit(auto& self, auto&& field) {
    field("steering_angle", self.steering_angle);
    field("steering_angle_velocity", self.steering_angle_velocity);
    field("speed", self.speed);
    field("acceleration", self.acceleration);
    field("jerk", self.jerk);
  }
  bool operator==(const AckermannDrive&) const = default;
};

}  // namespace pongsim::ros2::ackermann_msgs
