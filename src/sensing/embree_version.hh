#pragma once

#include <string>

namespace pongsim::sensing {

/// @return "3.13.5", of the library that is in memory.
std::string embreeVersion();

}  // namespace pongsim::sensing
