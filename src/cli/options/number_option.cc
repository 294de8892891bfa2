#include "cli/options/number_option.hh"

#include <charconv>
#include <cmath>
#include <cstdio>

#include "base/parse_number.hh"
#include "shared/program/failure.hh"

namespace pongsim::cli {

namespace {

[[noreturn]] void refuse(std::string_view option, const std::string& wanted, std::string_view text) {
  throw UsageError((option.starts_with('-') ? "option '" : "'") + std::string(option) + "' takes " + wanted +
                   ", not '" + std::string(text) + "'");
}

}  // namespace

std::uint64_t wholeNumber(std::string_view option, std::string_view text, std::uint64_t lowest, std::uint64_t highest) {
  // not base::parseInteger, which stops at 2^63
  std::uint64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stopped != end || value < lowest || value > highest) {
    const bool bounded = highest < std::numeric_limits<std::uint64_t>::max();
    refuse(option,
           "a whole number from " + std::to_string(lowest) + " to " + (bounded ? std::to_string(highest) : "2^64-1"),
           text);
  }
  return value;
}

double numberFromZero(std::string_view option, std::string_view text, std::string_view what) {
  const std::optional<double> value = base::parseDouble(text);
  if (!value || !std::isfinite(*value) || std::signbit(*value)) refuse(option, std::string(what) + " from 0", text);
  return *value;
}

std::string shortNumber(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

}  // namespace pongsim::cli
