#pragma once

#include <string>

#include "pongsim/element.hh"

namespace pongsim::ros2 {

/// A service of the simulation that somebody wants in ROS under a name of his choice.
struct ServiceRule {
  /// "/world/pong/control", in full.
  std::string ros;
  /// The simulation's: "/world/pong/control".
  std::string ignition;
  /// "ros_gz_interfaces/srv/ControlWorld"
  std::string type;
  SourcePosition position = {};
};

}  // namespace pongsim::ros2
