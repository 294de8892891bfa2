#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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

/// @return The number that a text begins with, as Fortress reads it: 5 of "5m".
std::optional<double> leadingNumber(std::string_view text);

/// @return The integer that a text begins with, decimal or as "0x1f".
std::optional<long long> leadingInteger(std::string_view text);

/// @return The numbers that the words of a text begin with, `most` of them at most, up to the first that begins with
/// none.
std::vector<double> leadingNumbers(std::string_view text, std::size_t most);

}  // namespace pongsim::sdf
