#include "cli/topic/field_condition.hh"

#include <utility>

#include "base/parse_number.hh"
#include "base/text.hh"
#include "shared/program/failure.hh"

namespace pongsim::cli {

namespace {

using Comparison = FieldCondition::Comparison;

// longer ones first, because `<=` starts with `<`
constexpr std::pair<std::string_view, Comparison> kComparisons[] = {
    {"==", Comparison::kEqual}, {"!=", Comparison::kUnequal}, {"<=", Comparison::kAtMost}, {">=", Comparison::kAtLeast},
    {"<", Comparison::kLess},   {">", Comparison::kMore},     {"=", Comparison::kEqual}};

template <class Value>
bool holds(const Value& left, Comparison comparison, const Value& right) {
  switch (comparison) {
    case Comparison::kEqual:
      return left == right;
    case Comparison::kUnequal:
      return left != right;
    case Comparison::kLess:
      return left < right;
    case Comparison::kAtMost:
      return left <= right;
    case Comparison::kMore:
      return left > right;
    case Comparison::kAtLeast:
      return left >= right;
  }
  return false;
}

std::optional<double> numberOf(const std::string& text) {
  if (text == "true" || text == "false") return text == "true" ? 1 : 0;
  return base::parseDouble(text);
}

}  // namespace

FieldCondition FieldCondition::parse(std::string_view text) {
  const std::size_t place = text.find_first_of("=!<>");
  for (const auto& [sign, comparison] : kComparisons) {
    if (place == std::string_view::npos || !text.substr(place).starts_with(sign)) continue;
    FieldCondition condition{std::string(base::trimmed(text.substr(0, place), " ")), comparison,
                             std::string(base::trimmed(text.substr(place + sign.size()), " "))};
    if (condition.path.empty() || condition.value.empty()) break;
    return condition;
  }
  throw UsageError("'" + std::string(text) + "' is not a condition on a field",
                   "write a path, a comparison (== != < <= > >=) and a value: 'pose.position.x >= 1'");
}

FieldCheck::FieldCheck(FieldPath path, FieldCondition condition)
    : path_(std::move(path)), condition_(std::move(condition)) {}

std::optional<FieldCheck> FieldCheck::make(const FieldCondition& condition, const std::string& type,
                                           MessageError& error) {
  std::optional<FieldPath> path = FieldPath::parse(type, condition.path, error);
  if (!path) return std::nullopt;
  FieldCheck check(*std::move(path), condition);
  const bool isOrder = condition.comparison != Comparison::kEqual && condition.comparison != Comparison::kUnequal;
  if (!check.path_.isNumber()) {
    if (!isOrder) return check;
    error = {0, 0, "'" + condition.path + "' of " + type + " is not a number", "compare it with == or !="};
    return std::nullopt;
  }
  const std::optional<double> number = numberOf(condition.value);
  if (!number) {
    error = {0, 0, "'" + condition.path + "' of " + type + " is a number, but '" + condition.value + "' is not", ""};
    return std::nullopt;
  }
  check.number_ = *number;
  return check;
}

bool FieldCheck::isMetBy(const Message& message) const {
  if (path_.isNumber()) {
    const std::optional<double> number = path_.numberIn(message);
    return number && holds(*number, condition_.comparison, number_);
  }
  const std::optional<std::string> value = path_.valueIn(message);
  return value && holds(*value, condition_.comparison, condition_.value);
}

}  // namespace pongsim::cli
