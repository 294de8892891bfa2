#pragma once

#include <string>

#include "ros2/types/geometry_msgs.hh"
#include "ros2/types/std_msgs.hh"

namespace pongsim::ros2::nav_msgs {

struct Odometry {
  static constexpr const char* kName = "nav_msgs/msg/Odometry";
  std_msgs::Header header;
  std::string child_frame_id;
  geometry_msgs::PoseWithCovariance pose;
  geometry_msgs::TwistWithCovariance twist;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("child_frame_id", self.child_frame_id);
    field("pose", self.pose);
    field("twist", self.twist);
  }
  bool operator==(const Odometry&) const = default;
};

}  // namespace pongsim::ros2::nav_msgs
