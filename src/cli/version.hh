#pragma once

#include <string>

namespace pongsim::cli {

/// @return pongsim's version, and on lines of their own those of the libraries that its results depend on.
std::string versionText();

}  // namespace pongsim::cli
