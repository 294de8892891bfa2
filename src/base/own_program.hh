#pragma once

#include <filesystem>
#include <string_view>

namespace pongsim::base {

/// @param name Such as "pongsim-fuel".
/// @return A program in libexec/pongsim/ of this installation or build tree; empty if it is not installed.
std::filesystem::path ownProgram(std::string_view name);

}  // namespace pongsim::base
