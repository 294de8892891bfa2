#pragma once

#include "ros2/types/std_msgs.hh"

namespace pongsim::ros2::geometry_msgs {

struct Vector3 {
  static constexpr const char* kName = "geometry_msgs/msg/Vector3";
  double x = 0;
  double y = 0;
  double z = 0;
  static void visit(auto& self, auto&& field) {
    field("x", self.x);
    field("y", self.y);
    field("z", self.z);
  }
  bool operator==(const Vector3&) const = default;
};

struct Twist {
  static constexpr const char* kName = "geometry_msgs/msg/Twist";
  Vector3 linear;
  Vector3 angular;
  static void visit(auto& self, auto&& field) {
    field("linear", self.linear);
    field("angular", self.angular);
  }
  bool operator==(const Twist&) const = default;
};

}  // namespace pongsim::ros2::geometry_msgs
