#pragma once

#include <span>
#include <string_view>

namespace pongsim::plugin {

/// @return The short names of all systems that come with Gazebo Fortress.
std::span<const std::string_view> fortressSystems();

}  // namespace pongsim::plugin
