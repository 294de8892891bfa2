#pragma once

#include <string>

namespace pongsim::cli {

/// @return pongsim's version and, one per line, those of the libraries that its results depend on.
std::string versionText();

}  // namespace pongsim::cli
