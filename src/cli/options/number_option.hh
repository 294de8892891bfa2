#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

namespace pongsim::cli {

/// A year: practically for ever, and within the clock's range.
inline constexpr std::uint64_t kLongestMs = 365ULL * 86400 * 1000;

/// Parses the value of an integer option.
/// @throws UsageError if `text` is not an integer within the bounds.
std::uint64_t wholeNumber(std::string_view option, std::string_view text, std::uint64_t lowest = 0,
                          std::uint64_t highest = std::numeric_limits<std::uint64_t>::max());

/// Parses the value of an option that takes a finite number of at least 0.
/// @param what Description for the message: "a number of seconds".
/// @throws UsageError if `text` is not such a number.
double numberFromZero(std::string_view option, std::string_view text, std::string_view what);

/// @return `value` in its usual form: "1", "0.5".
std::string shortNumber(double value);

}  // namespace pongsim::cli
