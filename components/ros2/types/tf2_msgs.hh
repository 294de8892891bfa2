#pragma once

#include <vector>

#include "ros2/types/geometry_msgs.hh"

namespace pongsim::ros2::tf2_msgs {

struct TFMessage {
  static constexpr const char* kName = "tf2_msgs/msg/TFMessage";
  std::vector<geometry_msgs::TransformStamped> transforms;
  static void visit(auto& self, auto&& field) { field("transforms", self.transforms); }
  bool operator==(const TFMessage&) const = default;
};

}  // namespace pongsim::ros2::tf2_msgs
