#pragma once

#include <span>
#include <string>
#include <string_view>

namespace pongsim::ros2 {

// Nodes of all distributions are met at once. The name of one tells only what nodes do not announce themselves.

/// @return All names of distributions of ROS 2, in their order.
std::span<const std::string_view> distroNames();
bool isDistro(std::string_view name);

/// @return Whether the distribution ships the older version of interfaces of which there are two (simulation_interfaces
/// 1). Without a name, or for an unknown one: true.
bool shipsOlderInterfaces(std::string_view name);

/// @return ROS_DISTRO, or empty.
std::string distroOfEnvironment();

}  // namespace pongsim::ros2
