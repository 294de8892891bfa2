#pragma once

#include <string>
#include <string_view>

namespace pongsim::transport {

/// Stands for all types in a subscription to any type; not a valid type name.
inline constexpr std::string_view kAnyType = "*";

/// @return The full name of a message type.
/// @throws std::invalid_argument for an unknown one.
std::string knownType(std::string_view name);

/// Like `knownType`, but unknown names are returned unchanged.
/// @throws std::invalid_argument for one that can't be announced.
std::string anyType(std::string_view name);

}  // namespace pongsim::transport
