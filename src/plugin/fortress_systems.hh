#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pongsim::plugin {

/// @return The short names of all systems that come with Gazebo Fortress.
std::span<const std::string_view> fortressSystems();

/// @param available Short names of the installed ones.
/// @return The short names of Fortress's systems that are not installed, are in no package of pongsim, and are not
/// built in.
std::vector<std::string_view> missingSystems(std::span<const std::string> available);

/// @param name As returned by `systemName`: "gazebo_ros_control".
/// @return Whether it is a plugin of Gazebo Classic or ROS, which worlds and robots still name and Fortress can't load
/// either.
bool isForeignPlugin(std::string_view name);

/// @param name As returned by `systemName`: "gz_ros2_control-system".
/// @return The additional package that contains it; empty: none.
std::string_view packageOf(std::string_view name);

}  // namespace pongsim::plugin
