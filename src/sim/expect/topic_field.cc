#include "sim/expect/topic_field.hh"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string_view>
#include <utility>
#include <vector>

namespace pongsim::sim {

namespace {

std::string quoted(const std::string& text) { return "'" + text + "'"; }

double meanOf(const std::vector<double>& numbers) {
  return numbers.empty() ? std::numeric_limits<double>::quiet_NaN()
                         : std::accumulate(numbers.begin(), numbers.end(), 0.0) / static_cast<double>(numbers.size());
}

}  // namespace

Outcome<TopicField> TopicField::of(const Criterion& criterion, const std::string& type) {
  constexpr std::pair<std::string_view, Fold> kFolds[] = {
      {"min(", Fold::kMin}, {"max(", Fold::kMax}, {"mean(", Fold::kMean}, {"size(", Fold::kSize}};
  std::string_view path = criterion.field;
  Fold fold = Fold::kNone;
  for (const auto& [word, meant] : kFolds) {
    if (!path.starts_with(word) || !path.ends_with(')')) continue;
    path = path.substr(word.size(), path.size() - word.size() - 1);
    fold = meant;
    break;
  }
  MessageError error;
  std::optional<FieldPath> found = FieldPath::parse(type, path, error);
  if (!found) return {{}, error.message + (error.hint.empty() ? "" : " (" + error.hint + ")")};
  if (fold != Fold::kNone && !found->isNumberList()) {
    return {{}, "field " + quoted(std::string(path)) + " of " + type + " is not a list of numbers"};
  }
  const bool isNumber = fold != Fold::kNone || found->isNumber();
  if (isNumber && criterion.text) {
    return {{},
            "field " + quoted(criterion.field) + " of " + type + " is a number, and not " + quoted(*criterion.text)};
  }
  if (!isNumber && !criterion.text) {
    const std::string hint = found->isNumberList() ? " (write min(" + std::string(path) + ") or another of its values)"
                                                   : " (compare it with a text)";
    return {{}, "field " + quoted(criterion.field) + " of " + type + " is not a number" + hint};
  }
  return {TopicField(*std::move(found), fold), ""};
}

FieldValue TopicField::in(const Message& message) const {
  if (fold_ == Fold::kNone) {
    if (path_.isNumber()) return {path_.numberIn(message), {}};
    return {{}, path_.valueIn(message)};
  }
  const std::vector<double> numbers = path_.numbersIn(message);
  switch (fold_) {
    case Fold::kSize:
      return {static_cast<double>(numbers.size()), {}};
    case Fold::kMean:
      return {meanOf(numbers), {}};
    default:
      break;
  }
  if (numbers.empty()) return {};
  return {fold_ == Fold::kMin ? *std::min_element(numbers.begin(), numbers.end())
                              : *std::max_element(numbers.begin(), numbers.end()),
          {}};
}

}  // namespace pongsim::sim
