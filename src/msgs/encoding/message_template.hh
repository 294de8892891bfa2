#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace pongsim::msgs {

/// @return A message of the type that `name` stands for as text to fill in: every field with its default, lists and
/// choices as comments; nothing where there is no such type.
std::optional<std::string> messageTemplate(std::string_view name);

}  // namespace pongsim::msgs
