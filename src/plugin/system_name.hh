#pragma once

#include <string>
#include <string_view>

namespace pongsim::plugin {

/// @return The short name of the system that the filename of a `<plugin>` asks for. `ignition-gazebo-X-system`,
/// `ignition-gazebo6-X-system`, `libignition-gazebo-X-system.so`, `gz-sim-X-system`, `pongsim-X-system` all give
/// `X`, and so does `ignition-launch-X`; a name of another form is given back without `lib` and `.so`.
std::string systemName(std::string_view filename);

}  // namespace pongsim::plugin
