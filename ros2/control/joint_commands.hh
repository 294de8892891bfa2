#pragma once

#include <ignition/msgs/model.pb.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ros2/control/control_block.hh"

namespace pongsim::ros2 {

/// What a message commands one joint; not what it says nothing of.
struct JointCommand {
  std::optional<double> position = std::nullopt;
  std::optional<double> velocity = std::nullopt;
  std::optional<double> effort = std::nullopt;
};

/// Reads a message of commands, an ignition.msgs.Model that was made of a sensor_msgs/JointState: what that said
/// nothing of is not a number in it.
///
/// topic_based_ros2_control leaves out of each of the three lists the joints that have no such interface, so that its
/// numbers are not those of the names. A list that has as many numbers as there are names goes by the names; one that
/// has as many as there are joints with the interface among the names goes by those; else it goes by the first names.
/// @param joints In the order of the result.
/// @param unknown Replaced by the names that are none of the joints'.
std::vector<JointCommand> readCommands(const ignition::msgs::Model& message, std::span<const ControlledJoint> joints,
                                       std::vector<std::string>& unknown);

/// @return The one of the names that is spelt most alike, of those that are spelt at all alike; empty where none is.
std::string nearestName(const std::string& name, const std::vector<std::string>& names);

}  // namespace pongsim::ros2
