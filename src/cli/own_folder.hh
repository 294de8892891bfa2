#pragma once

#include <filesystem>

namespace pongsim::cli {

/// @return The folder of this program's own files: PREFIX/share/pongsim; empty if unknown.
std::filesystem::path ownFolder();

}  // namespace pongsim::cli
