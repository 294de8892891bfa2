#pragma once

#include <cstdint>
#include <string>

namespace pongsim::log {

/// @return Seconds with nine places: "12.345000000".
std::string secondsText(std::int64_t timeNs);

/// @return A time of a log for people: of the clock of the wall "2026-11-22 17:00:01.123 UTC", of the simulation
/// "12.345 s". What is later than 2001 is taken for the former.
std::string timeText(std::int64_t timeNs);

/// @param text Seconds, as "12.5".
/// @return Nanoseconds.
/// @throws UsageError, naming the option, where it is not a number of seconds, or is below 0.
std::int64_t timeFrom(const std::string& option, const std::string& text);

}  // namespace pongsim::log
