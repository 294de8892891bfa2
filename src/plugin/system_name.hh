#pragma once

#include <string>
#include <string_view>

namespace pongsim::plugin {

/// @return The short name of the system that a `<plugin>`'s filename stands for. `ignition-gazebo-X-system`,
/// `ignition-gazebo6-X-system`, `libignition-gazebo-X-system.so`, `gz-sim-X-system`, `pongsim-X-system` and
/// `ignition-launch-X` all give `X`; other names are returned without `lib` and `.so`.
std::string systemName(std::string_view filename);

}  // namespace pongsim::plugin
