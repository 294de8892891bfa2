#pragma once

#include <string>
#include <vector>

namespace pongsim::cli {

/// @return One sentence for each environment variable that is set and has an effect in Gazebo but not here: its name,
/// and what to use instead.
std::vector<std::string> ignoredVariables();

}  // namespace pongsim::cli
