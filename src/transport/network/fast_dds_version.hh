#pragma once

#include <string>

namespace pongsim::transport {

/// @return "2.9.1".
std::string fastDdsVersion();

}  // namespace pongsim::transport
