#pragma once

#include <string>

#include "pongsim/element.hh"

namespace pongsim::ros2 {

/// A service of the simulation that gets another name in ROS.
struct ServiceRule {
  /// Absolute name, "/world/pong/control".
  std::string ros;
  /// Name in the simulation: "/world/pong/control".
  std::string ignition;
  /// "ros_gz_interfaces/srv/ControlWorld"
  std::string type;
  SourcePosition position = {};
};

}  // namespace pongsim::ros2
