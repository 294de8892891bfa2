#pragma once

#include <vector>

#include "ros2/types/std_msgs.hh"

namespace pongsim::ros2::actuator_msgs {

struct Actuators {
  static constexpr const char* kName = "actuator_msgs/msg/Actuators";
  std_msgs::Header header;
  std::vector<double> position;
  std::vector<double> velocity;
  std::vector<double> normalized;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("position", self.position);
    field("velocity", self.velocity);
    field("normalized", self.normalized);
  }
  bool operator==(const Actuators&) const = default;
};

}  // namespace pongsim::ros2::actuator_msgs
