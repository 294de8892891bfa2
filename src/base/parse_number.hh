#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace pongsim::base {

/// Parses a number, independently of the locale: "1.5", "+3", "-1.79769e+308", "inf", "-INF", "nan", " 2 ". Numbers
/// that are too large become infinite, those that are too small zero.
/// @return Nothing if the text, apart from surrounding white space, is not exactly one number.
std::optional<double> parseDouble(std::string_view text);

/// Parses a decimal integer; ignores surrounding white space.
std::optional<long long> parseInteger(std::string_view text);

/// Parses numbers separated by white space.
/// @return Nothing if one of them is not a number.
std::optional<std::vector<double>> parseDoubles(std::string_view text);

}  // namespace pongsim::base
