#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pongsim::plugin {

/// @return The short names of all systems that come with Gazebo Fortress.
std::span<const std::string_view> fortressSystems();

/// @param available Short names of those that are here.
/// @return The short names of those of Fortress that are not, that no package of pongsim has, and that pongsim does not
/// do the work of itself.
std::vector<std::string_view> missingSystems(std::span<const std::string> available);

/// @param name As `systemName` has it: "gazebo_ros_control".
/// @return Whether it is one of the plugins of Gazebo Classic or of ROS, which worlds and robots still name and
/// Fortress can't load either.
bool isForeignPlugin(std::string_view name);

/// @param name As `systemName` has it: "gz_ros2_control-system".
/// @return The package beside pongsim that has it; empty: none.
std::string_view packageOf(std::string_view name);

}  // namespace pongsim::plugin
