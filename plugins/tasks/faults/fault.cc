#include "fault.hh"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <vector>

#include "pongsim/diagnostic.hh"
#include "pongsim/node.hh"
#include "pongsim/parameters.hh"
#include "pongsim/program/nearest_word.hh"

namespace pongsim::faults {

namespace {

// Times beyond this do not fit into nanoseconds with room for sums.
constexpr double kLongest = 1e9;
constexpr double kLargestNumber = 1e12;

struct KindName {
  std::string_view name;
  Kind kind;
  /// The attribute that names what it acts on.
  std::string_view target;
  /// Its further attributes.
  std::array<std::string_view, 3> others;
};

constexpr KindName kKinds[] = {
    {"drop", Kind::kDrop, "topic", {"probability"}},
    {"duplicate", Kind::kDuplicate, "topic", {"probability"}},
    {"delay", Kind::kDelay, "topic", {"probability", "delay"}},
    {"noise", Kind::kNoise, "topic", {"probability", "stddev", "field"}},
    {"freeze", Kind::kFreeze, "topic", {}},
    {"sensor", Kind::kSensor, "sensor", {}},
    {"stick", Kind::kStick, "joint", {}},
    {"slip", Kind::kSlip, "joint", {"friction"}},
    {"weaken", Kind::kWeaken, "joint", {"effort", "factor"}},
};
constexpr std::string_view kCommon[] = {"type", "from", "to", "every"};

std::string listed(std::span<const std::string_view> words) {
  std::string text;
  for (const std::string_view word : words) text += (text.empty() ? "" : ", ") + std::string(word);
  return text;
}

[[noreturn]] void refuseAt(const SourcePosition& position, std::string message, std::string hint = {}) {
  throw Error({Severity::kError, position, std::move(message), std::move(hint)});
}

const KindName& kindOf(const Element& element) {
  std::vector<std::string_view> names;
  for (const KindName& kind : kKinds) names.push_back(kind.name);
  const Element::Attribute* type = element.attribute("type");
  if (type == nullptr) refuseAt(element.position, "<fault> has no type", "types are " + listed(names));
  const auto* found = std::ranges::find(kKinds, type->value, &KindName::name);
  if (found != std::end(kKinds)) return *found;
  const std::string near = didYouMean(type->value, names);
  refuseAt(type->position, "there is no fault '" + type->value + "'",
           near.empty() ? "types are " + listed(names) : near);
}

void checkAttributes(const Element& element, const KindName& kind) {
  std::vector<std::string_view> known(std::begin(kCommon), std::end(kCommon));
  known.push_back(kind.target);
  for (const std::string_view name : kind.others) {
    if (!name.empty()) known.push_back(name);
  }
  for (const Element::Attribute& attribute : element.attributes) {
    if (std::ranges::find(known, attribute.name) != known.end()) continue;
    refuseAt(attribute.position, "a fault of type '" + std::string(kind.name) + "' has no '" + attribute.name + "'",
             hintFor(attribute.name, known));
  }
}

/// @return The number of an attribute, if it is there.
std::optional<double> numberIn(const Element& element, std::string_view name, double least, double most) {
  const Element::Attribute* attribute = element.attribute(name);
  if (attribute == nullptr) return std::nullopt;
  const std::string& text = attribute->value;
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  // NaN is not within the bounds
  if (error == std::errc() && end == text.data() + text.size() && value >= least && value <= most) return value;
  const auto inShort = [](double number) {
    char digits[32];
    return std::string(digits, std::to_chars(digits, digits + sizeof digits, number).ptr);
  };
  refuseAt(attribute->position, "'" + std::string(name) + "' of a fault must be a number from " + inShort(least) +
                                    " to " + inShort(most) + ", not '" + text + "'");
}

std::optional<Time> timeIn(const Element& element, std::string_view name) {
  const std::optional<double> seconds = numberIn(element, name, 0, kLongest);
  return seconds ? std::optional(fromSeconds(*seconds)) : std::nullopt;
}

double required(const Element& element, const KindName& kind, std::string_view name, std::optional<double> value) {
  if (!value)
    refuseAt(element.position, "a fault of type '" + std::string(kind.name) + "' needs '" + std::string(name) + "'");
  return *value;
}

void readTimes(const Element& element, Fault& fault) {
  fault.from = timeIn(element, "from").value_or(Time(0));
  fault.to = timeIn(element, "to").value_or(Time::max());
  fault.every = timeIn(element, "every").value_or(Time(0));
  if (fault.to <= fault.from) refuseAt(element.attribute("to")->position, "the fault ends before it begins");
  if (fault.every == Time(0)) return;
  if (element.attribute("to") == nullptr || fault.to - fault.from >= fault.every) {
    refuseAt(element.attribute("every")->position, "a fault that repeats must end before it begins again",
             "'to' is the end of the first time: from=\"2\" to=\"3\" every=\"10\"");
  }
}

}  // namespace

bool Fault::isActive(Time now) const {
  if (now < from) return false;
  if (every == Time(0)) return now < to;
  return (now - from) % every < to - from;
}

std::string hintFor(std::string_view word, std::span<const std::string_view> known) {
  std::string near = didYouMean(word, known);
  constexpr std::size_t kFew = 12;
  if (!near.empty() || known.empty() || known.size() > kFew) return near;
  return "there are " + listed(known);
}

Fault faultOf(const Element& element) {
  const KindName& kind = kindOf(element);
  checkAttributes(element, kind);
  Fault fault;
  fault.kind = kind.kind;
  const Element::Attribute* target = element.attribute(kind.target);
  if (target == nullptr || target->value.empty()) {
    refuseAt(element.position,
             "a fault of type '" + std::string(kind.name) + "' needs '" + std::string(kind.target) + "'");
  }
  fault.target = target->value;
  fault.position = target->position;
  if (kind.target == "topic") {
    if (const auto error = topicNameError(fault.target)) {
      refuseAt(target->position, "'" + fault.target + "' is no name of a topic: it " + *error);
    }
    if (!fault.target.starts_with('/')) fault.target.insert(0, "/");
  }
  readTimes(element, fault);
  fault.probability = numberIn(element, "probability", 0, 1).value_or(1);
  fault.field = element.attributeOr("field", "");
  fault.friction = numberIn(element, "friction", 0, kLargestNumber).value_or(fault.friction);
  fault.effort = numberIn(element, "effort", 0, kLargestNumber);
  fault.factor = numberIn(element, "factor", 0, 1);
  if (fault.kind == Kind::kDelay) {
    fault.delay = fromSeconds(required(element, kind, "delay", numberIn(element, "delay", 0, kLongest)));
  }
  if (fault.kind == Kind::kNoise) {
    fault.deviation = required(element, kind, "stddev", numberIn(element, "stddev", 0, kLargestNumber));
  }
  if (fault.kind == Kind::kWeaken && fault.effort.has_value() == fault.factor.has_value()) {
    refuseAt(element.position, "a fault of type 'weaken' needs either 'effort' or 'factor'");
  }
  return fault;
}

}  // namespace pongsim::faults
