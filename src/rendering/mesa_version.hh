#pragma once

#include <string>

namespace pongsim::rendering {

/// @return The version of Mesa that draws camera images, "22.3.6"; "not installed" without it.
std::string mesaVersion();

}  // namespace pongsim::rendering
