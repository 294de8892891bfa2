#pragma once

#include <string>

namespace pongsim::physics {

/// @return "3.24".
std::string bulletVersion();

}  // namespace pongsim::physics
