#pragma once

#include <string>
#include <vector>

namespace pongsim::cli {

/// @return A sentence on each environment variable that is set, would change what Fortress does, and changes nothing
/// here: which, and what to use instead.
std::vector<std::string> unheardVariables();

}  // namespace pongsim::cli
