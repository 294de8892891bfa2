#pragma once

#include <ignition/msgs/model.pb.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ros2/control/control_block.hh"

namespace pongsim::ros2 {

/// The commands in a message for one joint; unset values are not commanded.
struct JointCommand {
  std::optional<double> position = std::nullopt;
  std::optional<double> velocity = std::nullopt;
  std::optional<double> effort = std::nullopt;
};

/// Reads a message of commands, an ignition.msgs.Model converted from a sensor_msgs/JointState, in which missing values
/// are NaN.
///
/// topic_based_ros2_control leaves joints without the respective interface out of each of the three lists, so that
/// values and names have different indices. A list with as many values as names follows the names. A list with as many
/// values as there are named joints with the interface follows those. Otherwise it follows the first names.
/// @param joints In the order of the result.
/// @param unknown Replaced by the names that do not belong to any of the joints.
std::vector<JointCommand> readCommands(const ignition::msgs::Model& message, std::span<const ControlledJoint> joints,
                                       std::vector<std::string>& unknown);

/// @return The most similar name, if any is similar at all; else empty.
std::string nearestName(const std::string& name, const std::vector<std::string>& names);

}  // namespace pongsim::ros2
