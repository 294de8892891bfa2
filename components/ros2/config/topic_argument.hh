#pragma once

#include <optional>
#include <string_view>

#include "ros2/config/rule_text.hh"

namespace pongsim::ros2 {

/// Parses an argument of ros_gz's `parameter_bridge`:
///
///     /chatter@std_msgs/msg/String@ignition.msgs.StringMsg    both ways
///     /scan@sensor_msgs/msg/LaserScan[ignition.msgs.LaserScan   to ROS
///     /cmd_vel@geometry_msgs/msg/Twist]ignition.msgs.Twist    from ROS
///     /world/W/control@ros_gz_interfaces/srv/ControlWorld     a service; with @REQUEST@REPLY behind it or without
///
/// @param position Its position, for messages.
/// @return Nothing, with an error in `diagnostics`, if it is none of these.
std::optional<RuleText> readTopicArgument(std::string_view text, const SourcePosition& position,
                                          Diagnostics& diagnostics);

}  // namespace pongsim::ros2
