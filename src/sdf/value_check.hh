#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "pongsim/diagnostic.hh"

namespace pongsim::sdf {

/// What is wrong with a value of the format.
struct WrongValue {
  /// A warning where Fortress takes a part of the text.
  Severity severity;
  /// "three numbers"
  std::string_view expected;
};

/// @param type As the table of the format names it: "vector3".
/// @return Nothing where the text is of that type, or empty, which stands for the default.
std::optional<WrongValue> checkValue(std::string_view type, std::string_view text);

/// The text as a message quotes it: shortened where it is long.
std::string quoted(const std::string& text);

}  // namespace pongsim::sdf
