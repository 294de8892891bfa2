#pragma once

#include <span>
#include <string_view>

namespace pongsim::plugin {

/// @return The short names of all systems that come with Gazebo Fortress.
std::span<const std::string_view> fortressSystems();

/// @param name As `systemName` has it: "gazebo_ros_control".
/// @return Whether it is one of the plugins of Gazebo Classic or of ROS, which worlds and robots still name and
/// Fortress can't load either.
bool isForeignPlugin(std::string_view name);

}  // namespace pongsim::plugin
