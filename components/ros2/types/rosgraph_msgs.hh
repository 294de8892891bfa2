#pragma once

#include "ros2/types/builtin_interfaces.hh"

namespace pongsim::ros2::rosgraph_msgs {

struct Clock {
  static constexpr const char* kName = "rosgraph_msgs/msg/Clock";
  builtin_interfaces::Time clock;
  static void visit(auto& self, auto&& field) { field("clock", self.clock); }
  bool operator==(const Clock&) const = default;
};

}  // namespace pongsim::ros2::rosgraph_msgs
