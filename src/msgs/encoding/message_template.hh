#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace pongsim::msgs {

/// @return A message of the named type as text to fill in: every field with its default, with comments on repeated
/// fields and enumerations; nothing if there is no such type.
std::optional<std::string> messageTemplate(std::string_view name);

}  // namespace pongsim::msgs
