#include "log/command/times.hh"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <ctime>

#include "shared/program/failure.hh"

namespace pongsim::log {

namespace {

constexpr std::int64_t kSecond = 1'000'000'000;
constexpr std::int64_t kFirstOfWall = 1'000'000'000 * kSecond;

}  // namespace

std::string secondsText(std::int64_t timeNs) {
  // the sign applies to both parts
  const std::uint64_t size = timeNs < 0 ? 0 - static_cast<std::uint64_t>(timeNs) : static_cast<std::uint64_t>(timeNs);
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%s%llu.%09llu", timeNs < 0 ? "-" : "",
                static_cast<unsigned long long>(size / kSecond), static_cast<unsigned long long>(size % kSecond));
  return text.data();
}

std::string timeText(std::int64_t timeNs) {
  if (timeNs < kFirstOfWall) {
    const std::string seconds = secondsText(timeNs);
    return seconds.substr(0, seconds.size() - 6) + " s";
  }
  const std::time_t seconds = timeNs / kSecond;
  std::tm parts{};
  gmtime_r(&seconds, &parts);
  std::array<char, 40> date{};
  std::strftime(date.data(), date.size(), "%Y-%m-%d %H:%M:%S", &parts);
  const std::string nanoseconds = secondsText(timeNs);
  // three of the nine decimals
  return date.data() + nanoseconds.substr(nanoseconds.size() - 10, 4) + " UTC";
}

std::int64_t timeFrom(const std::string& option, const std::string& text) {
  double seconds = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seconds);
  if (error != std::errc() || end != text.data() + text.size() || !(seconds >= 0) || seconds > 9e9) {
    throw cli::UsageError("option '" + option + "' takes a number of seconds, not '" + text + "'");
  }
  return std::llround(seconds * 1e9);
}

}  // namespace pongsim::log
