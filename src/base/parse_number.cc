#include "base/parse_number.hh"

#include <charconv>
#include <cmath>
#include <limits>

#include "base/text.hh"

namespace pongsim::base {

namespace {

/// @return Whether the decimal number `digits`, which is out of a double's range, is too large rather than too small.
bool isTooLarge(std::string_view digits) {
  const std::size_t exponent = digits.find_first_of("eE");
  if (exponent == std::string_view::npos) return digits.find_first_not_of("-0.") < digits.find('.');
  return digits.substr(exponent + 1, 1) != "-";
}

}  // namespace

std::optional<double> parseDouble(std::string_view text) {
  std::string_view digits = trimmed(text);
  if (digits.starts_with('+')) {
    digits.remove_prefix(1);
    if (digits.starts_with('-')) return std::nullopt;
  }
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (digits.empty() || end != digits.data() + digits.size()) return std::nullopt;
  if (error == std::errc::result_out_of_range) {
    const double magnitude = isTooLarge(digits) ? std::numeric_limits<double>::infinity() : 0;
    return digits.starts_with('-') ? -magnitude : magnitude;
  }
  return error == std::errc() ? std::optional(value) : std::nullopt;
}

std::optional<long long> parseInteger(std::string_view text) {
  std::string_view digits = trimmed(text);
  if (digits.starts_with('+')) {
    digits.remove_prefix(1);
    if (digits.starts_with('-')) return std::nullopt;
  }
  long long value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (digits.empty() || error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  return value;
}

std::optional<std::vector<double>> parseDoubles(std::string_view text) {
  std::vector<double> values;
  std::size_t begin = text.find_first_not_of(kWhiteSpace);
  while (begin != std::string_view::npos) {
    const std::size_t end = std::min(text.find_first_of(kWhiteSpace, begin), text.size());
    const std::optional<double> value = parseDouble(text.substr(begin, end - begin));
    if (!value) return std::nullopt;
    values.push_back(*value);
    begin = text.find_first_not_of(kWhiteSpace, end);
  }
  return values;
}

}  // namespace pongsim::base
