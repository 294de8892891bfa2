#pragma once

#include <cstdint>
#include <string>

namespace pongsim::log {

/// @return Seconds with nine decimals: "12.345000000".
std::string secondsText(std::int64_t timeNs);

/// @return A time in a log for people: wall time as "2026-11-22 17:00:01.123 UTC", simulated time as "12.345 s". Times
/// after 2001 are taken for wall time.
std::string timeText(std::int64_t timeNs);

/// @param text Seconds, such as "12.5".
/// @return Nanoseconds.
/// @throws UsageError, naming the option, if it is not a number of seconds, or is negative.
std::int64_t timeFrom(const std::string& option, const std::string& text);

}  // namespace pongsim::log
