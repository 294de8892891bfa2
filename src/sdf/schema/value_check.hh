#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pongsim/diagnostic.hh"

namespace pongsim::sdf {

/// A value that does not fit its type.
struct WrongValue {
  /// A warning if Fortress reads part of the text.
  Severity severity;
  /// "three numbers"
  std::string_view expected;
};

/// @param type Name of the type in the format's table: "vector3".
/// @return Nothing if the text has this type, or is empty, which means the default.
std::optional<WrongValue> checkValue(std::string_view type, std::string_view text);

/// The text as quoted in messages: shortened if long.
std::string quoted(const std::string& text);

/// @return The number at the start of a text, as Fortress reads it: 5 in "5m".
std::optional<double> leadingNumber(std::string_view text);

/// @return The integer at the start of a text, decimal or as "0x1f".
std::optional<long long> leadingInteger(std::string_view text);

/// @return The numbers at the start of each word of a text: at most `most`, up to the first word that does not start
/// with one.
std::vector<double> leadingNumbers(std::string_view text, std::size_t most);

}  // namespace pongsim::sdf
