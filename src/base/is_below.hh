#pragma once

#include <filesystem>

namespace pongsim::base {

/// @return Whether a file or folder lies in a folder or is it, after following symbolic links. False where that can't
/// be told, and for an empty folder.
bool isBelow(const std::filesystem::path& file, const std::filesystem::path& folder);

}  // namespace pongsim::base
