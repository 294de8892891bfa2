#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace pongsim::msgs {

/// @return The definition of the message type that `name` stands for, as protobuf's language has it and with the types
/// nested in it; nothing where there is no such type.
std::optional<std::string> definition(std::string_view name);

}  // namespace pongsim::msgs
