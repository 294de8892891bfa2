#pragma once

#include <filesystem>

namespace pongsim::cli {

/// @return What came with this program is there: PREFIX/share/pongsim; empty where it can't be told.
std::filesystem::path ownFolder();

}  // namespace pongsim::cli
