#pragma once

#include <string>
#include <string_view>

namespace pongsim::transport {

/// What stands for a type where a subscription takes any: no type's name.
inline constexpr std::string_view kAnyType = "*";

/// @return The full name of a message type.
/// @throws std::invalid_argument for an unknown one.
std::string knownType(std::string_view name);

/// As `knownType`, and a name that nobody here knows as it is.
/// @throws std::invalid_argument for one that can't be told to others.
std::string anyType(std::string_view name);

}  // namespace pongsim::transport
