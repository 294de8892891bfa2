#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace pongsim::base {

/// Reads a number, whatever the locale says: "1.5", "+3", "-1.79769e+308", "inf", "-INF", "nan", " 2 ". A number too
/// large becomes infinite, one too small zero.
/// @return Nothing where the text, white space around it apart, is not one number.
std::optional<double> parseDouble(std::string_view text);

/// Reads a decimal integer, white space around it apart.
std::optional<long long> parseInteger(std::string_view text);

/// Reads numbers with white space between them.
/// @return Nothing where one of them is not a number.
std::optional<std::vector<double>> parseDoubles(std::string_view text);

}  // namespace pongsim::base
