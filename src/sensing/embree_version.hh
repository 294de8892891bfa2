#pragma once

#include <string>

namespace pongsim::sensing {

/// @return Version of the library, "3.13.5"; "not installed" without it.
std::string embreeVersion();

}  // namespace pongsim::sensing
