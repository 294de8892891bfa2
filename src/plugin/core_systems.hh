#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pongsim/declaration.hh"

namespace pongsim::plugin {

/// A system of Fortress whose work pongsim does itself, in each run: it has no library.
struct CoreSystem {
  /// As `systemName` has it: "user-commands".
  std::string name;
  std::string className;
  Declaration declaration;
};

const std::vector<CoreSystem>& coreSystems();

/// @return The one of that name, in any of the forms that worlds use, or null.
const CoreSystem* coreSystem(std::string_view filename);

}  // namespace pongsim::plugin
