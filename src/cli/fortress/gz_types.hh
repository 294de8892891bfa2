#pragma once

#include <string>

namespace pongsim::cli {

/// @param text For a reader: names of message types, topics with their types, a definition.
/// @param asGz Whether pongsim is called as `gz`.
/// @return The same; as `gz` with the types' names since Garden: gz.msgs.Twist for ignition.msgs.Twist, and
/// gz/msgs/twist.proto for the file.
std::string withTypeNames(std::string text, bool asGz);

}  // namespace pongsim::cli
