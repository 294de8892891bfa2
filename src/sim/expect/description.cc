#include <cmath>
#include <string>

#include "base/element_edit.hh"
#include "pongsim/expect/expectation.hh"
#include "sim/expect/criterion.hh"

namespace pongsim {

namespace {

using Relation = Criterion::Relation;

std::string wordsOf(const Criterion& criterion, double number) {
  return criterion.isTruth ? (number != 0 ? "true" : "false") : base::shortestText(number);
}

std::string wordsOf(const Criterion& criterion) {
  const std::string value = criterion.text ? "'" + *criterion.text + "'" : wordsOf(criterion, criterion.number);
  const std::string other = base::shortestText(criterion.other);
  switch (criterion.relation) {
    case Relation::kEquals:
      return criterion.field + " = " + value;
    case Relation::kDiffers:
      return criterion.field + " is not " + value;
    case Relation::kAbove:
      return criterion.field + " > " + value;
    case Relation::kAtLeast:
      return criterion.field + " >= " + value;
    case Relation::kBelow:
      return criterion.field + " < " + value;
    case Relation::kAtMost:
      return criterion.field + " <= " + value;
    case Relation::kNear:
      return criterion.field + " = " + value + " ± " + other;
    case Relation::kBetween:
      return criterion.field + " from " + value + " to " + other;
    case Relation::kContains:
      return criterion.field + " contains " + value;
    case Relation::kRecorded:
      return criterion.field + " as recorded ± " + other;
  }
  return {};
}

std::string wordsOf(const Signal& signal) {
  switch (signal.kind) {
    case Signal::Kind::kTopic:
      return signal.name;
    case Signal::Kind::kPose:
      return "pose of " + signal.name;
    case Signal::Kind::kVelocity:
      return "velocity of " + signal.name;
    case Signal::Kind::kJoint:
      return "joint " + signal.name;
    case Signal::Kind::kContact:
      return "contact of " + signal.name + " with " + (signal.other.empty() ? "anything" : signal.other);
  }
  return {};
}

/// @return ", from 1 s to 3 s", ", within 20 s".
std::string windowOf(const Expectation& expectation) {
  const bool isDeadline = expectation.mode == Expectation::Mode::kEventually ||
                          expectation.mode == Expectation::Mode::kInOrder || expectation.until;
  std::string words;
  const std::string since = expectation.after ? " after " + describe(*expectation.after) : "";
  if (expectation.to == expectation.from && !isDeadline) {
    words = ", at " + sim::secondsText(expectation.from) + since;
  } else if (expectation.to && expectation.from == Time(0)) {
    words = (isDeadline ? ", within " : ", for ") + sim::secondsText(*expectation.to) + since;
  } else if (expectation.to || expectation.from > Time(0)) {
    words = ", from " + sim::secondsText(expectation.from);
    if (expectation.to) words += " to " + sim::secondsText(*expectation.to);
    words += since;
  } else if (expectation.after) {
    words = "," + since;
  }
  return words;
}

}  // namespace

std::string describe(const Event& event) {
  std::string words = wordsOf(event.signal);
  // what a contact is by itself
  const bool isJustTouching = event.criteria.size() == 1 && event.criteria[0].field == "touching" &&
                              event.criteria[0].isTruth && event.criteria[0].number == 1;
  if (isJustTouching) return words;
  for (const Criterion& criterion : event.criteria) {
    words += (&criterion == event.criteria.data() ? ": " : ", ") + wordsOf(criterion);
  }
  if (event.criteria.empty() && event.signal.kind == Signal::Kind::kTopic) return "a message on " + words;
  return words;
}

std::string describe(const Expectation& expectation) {
  std::string words;
  switch (expectation.mode) {
    case Expectation::Mode::kEventually:
      words = "eventually ";
      break;
    case Expectation::Mode::kAlways:
      words = "always ";
      break;
    case Expectation::Mode::kNever:
      words = "never ";
      break;
    case Expectation::Mode::kInOrder:
      words = "in order ";
      break;
  }
  for (const Event& event : expectation.events) {
    words += (&event == expectation.events.data() ? "" : ", then ") + describe(event);
  }
  if (expectation.hold > Time(0)) words += ", for " + sim::secondsText(expectation.hold) + " on end";
  if (expectation.until) words += ", until " + describe(*expectation.until);
  return words + windowOf(expectation);
}

}  // namespace pongsim
