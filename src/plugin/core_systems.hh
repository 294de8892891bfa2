#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pongsim/declaration.hh"

namespace pongsim::plugin {

/// A system of Fortress that is built into pongsim and always runs; it has no library.
struct CoreSystem {
  /// As returned by `systemName`: "user-commands".
  std::string name;
  std::string className;
  Declaration declaration;
};

const std::vector<CoreSystem>& coreSystems();

/// @return The system with this name, in any of the forms that worlds use, or null.
const CoreSystem* coreSystem(std::string_view filename);

}  // namespace pongsim::plugin
