#include "sdf/schema/value_check.hh"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <string>
#include <vector>

#include "base/parse_number.hh"
#include "sdf/text/text_cursor.hh"
#include "sdf/text/values.hh"

namespace pongsim::sdf {

namespace {

struct NumberType {
  std::string_view name;
  std::string_view expected;
  std::size_t least;
  std::size_t most;
  bool isWhole = false;
  bool isUnsigned = false;
};

constexpr NumberType kNumberTypes[] = {
    {"double", "a number", 1, 1},
    {"float", "a number", 1, 1},
    {"int", "an integer", 1, 1, true},
    {"unsigned int", "a non-negative integer", 1, 1, true, true},
    {"vector2d", "two numbers", 2, 2},
    {"vector3", "three numbers", 3, 3},
    {"color", "three or four numbers, red green blue alpha", 3, 4},
    {"time", "a time: seconds and nanoseconds", 2, 2, true},
    // seven with rotation_format="quat_xyzw"
    {"pose", "a pose: six numbers, x y z roll pitch yaw", 6, 7},
};

std::vector<std::string_view> wordsOf(std::string_view text) {
  std::vector<std::string_view> words;
  std::size_t begin = text.find_first_not_of(kWhiteSpace);
  while (begin != std::string_view::npos) {
    const std::size_t end = std::min(text.find_first_of(kWhiteSpace, begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    begin = text.find_first_not_of(kWhiteSpace, end);
  }
  return words;
}

/// @return Whether the word is a hexadecimal integer, as masks often are: "0x1f".
bool isHexadecimal(std::string_view word) {
  if (!word.starts_with("0x") && !word.starts_with("0X")) return false;
  unsigned long long value = 0;
  const char* const last = word.data() + word.size();
  const auto [end, error] = std::from_chars(word.data() + 2, last, value, 16);
  return error == std::errc() && end == last;
}

bool isNumber(std::string_view word, const NumberType& type) {
  if (!type.isWhole) return base::parseDouble(word).has_value();
  if (isHexadecimal(word)) return true;
  const std::optional<long long> value = base::parseInteger(word);
  return value && (!type.isUnsigned || *value >= 0);
}

}  // namespace

std::optional<WrongValue> checkValue(std::string_view type, std::string_view text) {
  if (text.empty()) return std::nullopt;
  if (type == "bool") {
    if (parseFlag(text)) return std::nullopt;
    return WrongValue{Severity::kError, "'true' or 'false'"};
  }
  const auto* found = std::ranges::find(kNumberTypes, type, &NumberType::name);
  if (found == std::end(kNumberTypes)) return std::nullopt;
  const std::vector<std::string_view> words = wordsOf(text);
  const bool areNumbers = std::ranges::all_of(words, [&](std::string_view word) { return isNumber(word, *found); });
  if (areNumbers && words.size() >= found->least && words.size() <= found->most) return std::nullopt;
  const bool areRead = words.size() >= found->least &&
                       std::ranges::all_of(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(found->least),
                                           [](std::string_view word) { return leadingNumber(word).has_value(); });
  return WrongValue{areRead ? Severity::kWarning : Severity::kError, found->expected};
}

std::string quoted(const std::string& text) {
  constexpr std::size_t kLongest = 60;
  return text.size() > kLongest ? text.substr(0, kLongest) + "..." : text;
}

std::optional<double> leadingNumber(std::string_view text) {
  const std::vector<double> numbers = leadingNumbers(text, 1);
  return numbers.empty() ? std::nullopt : std::optional(numbers.front());
}

std::optional<long long> leadingInteger(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n\f\v"), text.size()));
  const bool isHexadecimal = text.starts_with("0x") || text.starts_with("0X");
  if (isHexadecimal) text.remove_prefix(2);
  if (text.starts_with('+')) text.remove_prefix(1);
  long long value = 0;
  const auto error = std::from_chars(text.data(), text.data() + text.size(), value, isHexadecimal ? 16 : 10).ec;
  return error == std::errc() ? std::optional(value) : std::nullopt;
}

std::vector<double> leadingNumbers(std::string_view text, std::size_t most) {
  std::vector<double> numbers;
  for (std::string_view word : wordsOf(text)) {
    if (numbers.size() == most) break;
    if (const std::optional<double> whole = base::parseDouble(word)) {
      numbers.push_back(*whole);
      continue;
    }
    if (word.starts_with('+')) word.remove_prefix(1);
    double value = 0;
    if (std::from_chars(word.data(), word.data() + word.size(), value).ec != std::errc()) break;
    numbers.push_back(value);
  }
  return numbers;
}

}  // namespace pongsim::sdf
