#pragma once

#include <string>
#include <string_view>

namespace pongsim::transport {

/// @return The name with a leading slash and without a trailing one.
/// @throws std::invalid_argument for an invalid name.
std::string absoluteTopic(std::string_view name);

}  // namespace pongsim::transport
