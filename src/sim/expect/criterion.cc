#include "sim/expect/criterion.hh"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

#include "base/element_edit.hh"

namespace pongsim::sim {

namespace {

using Relation = Criterion::Relation;

/// At least the smallest number: a strict bound that is just met is missed.
double strict(double miss) { return miss < 0 ? 0 : std::max(miss, std::numeric_limits<double>::min()); }

/// The recorded value at that time, between two records interpolated; before and after them that of the nearest.
double recordedAt(const RecordedValues& recorded, double time) {
  const auto& times = recorded.times;
  const auto next = static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), time) - times.begin());
  if (times.empty()) return std::numeric_limits<double>::quiet_NaN();
  if (next == 0) return recorded.values.front();
  if (next == times.size()) return recorded.values.back();
  const double share = (time - times[next - 1]) / (times[next] - times[next - 1]);
  return recorded.values[next - 1] + share * (recorded.values[next] - recorded.values[next - 1]);
}

double difference(double a, double b, bool isAngle) {
  return std::abs(isAngle ? std::remainder(a - b, 2 * std::numbers::pi) : a - b);
}

double missOfText(const Criterion& criterion, const std::string& text) {
  const bool isContained = text.find(criterion.text.value_or("")) != std::string::npos;
  switch (criterion.relation) {
    case Relation::kContains:
      return isContained ? 0 : 1;
    case Relation::kDiffers:
      return text != criterion.text ? 0 : 1;
    default:
      return text == criterion.text ? 0 : 1;
  }
}

double missOfNumber(const Criterion& criterion, double value, Time time, bool isAngle) {
  switch (criterion.relation) {
    case Relation::kEquals:
    case Relation::kContains:
      return std::abs(value - criterion.number);
    case Relation::kDiffers:
      return value != criterion.number ? 0 : 1;
    case Relation::kAbove:
      return strict(criterion.number - value);
    case Relation::kAtLeast:
      return std::max(0.0, criterion.number - value);
    case Relation::kBelow:
      return strict(value - criterion.number);
    case Relation::kAtMost:
      return std::max(0.0, value - criterion.number);
    case Relation::kNear:
      return std::max(0.0, difference(value, criterion.number, isAngle) - criterion.other);
    case Relation::kBetween:
      return std::max({0.0, criterion.number - value, value - criterion.other});
    case Relation::kRecorded:
      return std::max(0.0,
                      difference(value, recordedAt(*criterion.recorded, toSeconds(time)), isAngle) - criterion.other);
  }
  return 0;
}

/// Six digits: enough to see what is wrong.
std::string shown(double number) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.6g", number);
  return text;
}

}  // namespace

double missOf(const Criterion& criterion, const FieldValue& value, Time time, bool isAngle) {
  if (criterion.text) return value.text ? missOfText(criterion, *value.text) : 1;
  if (!value.number) return std::numeric_limits<double>::infinity();
  const double miss = missOfNumber(criterion, *value.number, time, isAngle);
  // comparisons with NaN meet nothing
  return std::isnan(miss) || std::isnan(*value.number) ? std::numeric_limits<double>::infinity() : miss;
}

std::string wordsOf(const Criterion& criterion, const FieldValue& value, Time time) {
  std::string words = criterion.field + " = ";
  if (value.text) {
    words += "'" + *value.text + "'";
  } else if (!value.number) {
    return criterion.field + " is not there";
  } else if (criterion.isTruth && (*value.number == 0 || *value.number == 1)) {
    words += *value.number == 1 ? "true" : "false";
  } else {
    words += shown(*value.number);
  }
  if (criterion.relation == Relation::kRecorded) {
    words += " instead of " + shown(recordedAt(*criterion.recorded, toSeconds(time)));
  }
  return words;
}

std::string secondsText(Time time) { return base::shortestText(toSeconds(time)) + " s"; }

}  // namespace pongsim::sim
