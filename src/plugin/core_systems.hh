#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pongsim/declaration.hh"

namespace pongsim::plugin {

/// A system of Fortress that is built into pongsim; it has no library.
struct CoreSystem {
  /// As returned by `systemName`: "user-commands".
  std::string name;
  std::string className;
  Declaration declaration;
  /// Of a system that only gives data to what it is in, which was read with the file: where it belongs, such as "a
  /// <visual>". Empty: it is in the world, and works there.
  std::string holders = {};
  /// Of one that is known, but has no effect: why.
  std::string limit = {};
};

const std::vector<CoreSystem>& coreSystems();

/// @return The system with this name, in any of the forms that worlds use, or null.
const CoreSystem* coreSystem(std::string_view filename);

}  // namespace pongsim::plugin
