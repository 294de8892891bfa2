#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

namespace pongsim::cli {

/// A year, which is as good as for ever, and fits the clock.
inline constexpr std::uint64_t kLongestMs = 365ULL * 86400 * 1000;

/// Reads the value of an option that takes a whole number.
/// @throws UsageError where `text` is none or not within the bounds.
std::uint64_t wholeNumber(std::string_view option, std::string_view text, std::uint64_t lowest = 0,
                          std::uint64_t highest = std::numeric_limits<std::uint64_t>::max());

/// Reads the value of an option that takes a finite number from 0.
/// @param what What it is, for the message: "a number of seconds".
/// @throws UsageError where `text` is none.
double numberFromZero(std::string_view option, std::string_view text, std::string_view what);

/// @return `value` as people write it: "1", "0.5".
std::string shortNumber(double value);

}  // namespace pongsim::cli
