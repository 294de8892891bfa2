#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pongsim::plugin {

/// @return The short names of all systems that come with Gazebo Fortress.
std::span<const std::string_view> fortressSystems();

/// A system that Fortress does not have.
struct LaterSystem {
  std::string_view name;
  /// The first release with it; "Rotary" is what is in development.
  std::string_view release;
};

/// @return Those of Garden to Jetty and of what is in development, in the order of the releases.
std::span<const LaterSystem> laterSystems();

/// @return Whether it is the short name of a system of Gazebo, whatever the release.
bool isOfGazebo(std::string_view name);

/// @param available Short names of the installed ones.
/// @return Whether a system is installed, in a package of pongsim, or built in.
bool isSupported(std::string_view name, std::span<const std::string> available);

/// @param available Short names of the installed ones.
/// @return The short names of Gazebo's systems that are not supported.
std::vector<std::string_view> missingSystems(std::span<const std::string> available);

/// @param name As returned by `systemName`: "gazebo_ros_control".
/// @return Whether it is a plugin of Gazebo Classic or ROS, which worlds and robots still name and Fortress can't load
/// either.
bool isForeignPlugin(std::string_view name);

/// @param name As returned by `systemName`: "gz_ros2_control-system".
/// @return The additional package that contains it; empty: none.
std::string_view packageOf(std::string_view name);

}  // namespace pongsim::plugin
