#include "pongsim/declaration.hh"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/nearest_word.hh"

namespace pongsim {

namespace {

// Limit for forces [N] and torques [N m]: that of messages in pongsim/commands.hh, whose header needs message types. A
// test compares the two.
constexpr double kLargestForce = 1e8;

std::string textOf(double value) {
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

/// @return The target's initial value as text; empty if there is none.
std::string defaultOf(const Parameter::Target& target) {
  struct ToText {
    std::string operator()(const double* value) const { return textOf(*value); }
    std::string operator()(const int* value) const { return std::to_string(*value); }
    std::string operator()(const bool* value) const { return *value ? "true" : "false"; }
    std::string operator()(const std::string* value) const { return *value; }
    std::string operator()(const Vector3* value) const {
      return textOf(value->x()) + " " + textOf(value->y()) + " " + textOf(value->z());
    }
    std::string operator()(const std::optional<double>* value) const { return *value ? textOf(**value) : ""; }
    std::string operator()(const std::vector<double>*) const { return {}; }
    std::string operator()(const std::vector<std::string>*) const { return {}; }
    std::string operator()(std::monostate) const { return {}; }
  };
  return std::visit(ToText{}, target);
}

[[noreturn]] void refuseValue(const Element& element, const std::string& rule) {
  throw Error({Severity::kError, element.position, "<" + element.name + "> " + rule, {}});
}

}  // namespace

Parameter::Parameter(std::string name, Target target, std::string unit, std::string text)
    : name_(std::move(name)),
      target_(target),
      unit_(std::move(unit)),
      text_(std::move(text)),
      fallback_(defaultOf(target)) {}

Parameter& Parameter::required() {
  isRequired_ = true;
  fallback_.clear();
  return *this;
}

Parameter& Parameter::above(double bound) {
  above_ = bound;
  return *this;
}

Parameter& Parameter::atLeast(double bound) {
  atLeast_ = bound;
  return *this;
}

Parameter& Parameter::atMost(double bound) {
  atMost_ = bound;
  return *this;
}

Parameter& Parameter::mayBeInfinite() {
  isFinite_ = false;
  return *this;
}

Parameter& Parameter::oneOf(std::vector<std::string> words) {
  words_ = std::move(words);
  return *this;
}

Parameter& Parameter::otherwise(std::string fallback) {
  fallback_ = std::move(fallback);
  return *this;
}

Parameter& Parameter::inFamily(std::string pattern) {
  family_ = std::move(pattern);
  return *this;
}

bool Parameter::isRepeated() const {
  return std::holds_alternative<std::vector<double>*>(target_) ||
         std::holds_alternative<std::vector<std::string>*>(target_);
}

std::string Parameter::type() const {
  struct Name {
    std::string operator()(const double*) const { return "number"; }
    std::string operator()(const int*) const { return "whole number"; }
    std::string operator()(const bool*) const { return "true or false"; }
    std::string operator()(const std::string*) const { return "text"; }
    std::string operator()(const Vector3*) const { return "three numbers"; }
    std::string operator()(const std::optional<double>*) const { return "number"; }
    std::string operator()(const std::vector<double>*) const { return "number"; }
    std::string operator()(const std::vector<std::string>*) const { return "text"; }
    std::string operator()(std::monostate) const { return "element"; }
  };
  return std::visit(Name{}, target_);
}

void Parameter::read(const Element& plugin) const {
  bool isGiven = false;
  for (const Element& element : plugin.children) {
    if (element.name != name_) continue;
    if (std::holds_alternative<std::monostate>(target_)) {
      isGiven = true;
    } else if (!element.text.empty() && (!isGiven || isRepeated())) {
      // if one value is expected and there are several, the first counts, as in Fortress
      isGiven = true;
      readElement(element);
    }
  }
  if (isGiven || !isRequired_) return;
  const Element* empty = plugin.child(name_);
  throw Error({Severity::kError, (empty != nullptr ? *empty : plugin).position, "no <" + name_ + "> is given", text_});
}

void Parameter::readElement(const Element& element) const {
  struct Read {
    const Parameter& parameter;
    const Element& element;
    void operator()(std::monostate) const {}
    void operator()(double* value) const { *value = parameter.number(element); }
    void operator()(int* value) const {
      parameter.number(element);
      *value = element.as<int>();
    }
    void operator()(bool* value) const { *value = element.as<bool>(); }
    void operator()(std::string* value) const { *value = parameter.word(element); }
    void operator()(Vector3* value) const {
      *value = element.as<Vector3>();
      if (!value->allFinite()) refuseValue(element, "must be three finite numbers");
    }
    void operator()(std::optional<double>* value) const { *value = parameter.number(element); }
    void operator()(std::vector<double>* value) const { value->push_back(parameter.number(element)); }
    void operator()(std::vector<std::string>* value) const { value->push_back(parameter.word(element)); }
  };
  std::visit(Read{*this, element}, target_);
}

double Parameter::number(const Element& element) const {
  const double value = element.as<double>();
  if (above_ && (!(value > *above_) || (isFinite_ && std::isinf(value)))) {
    refuseValue(element, "must be above " + (*above_ == 0 ? "zero" : textOf(*above_)));
  }
  if (atLeast_ && (!(value >= *atLeast_) || (isFinite_ && std::isinf(value)))) {
    refuseValue(element, "must be " + (*atLeast_ == 0 ? "zero or more" : "at least " + textOf(*atLeast_)));
  }
  if (atMost_ && !(value <= *atMost_)) refuseValue(element, "must be at most " + textOf(*atMost_));
  if (std::isnan(value) || (isFinite_ && std::isinf(value))) refuseValue(element, "must be a finite number");
  const bool isForce = unit_ == "N" || unit_ == "N m";
  if (isForce && std::abs(value) > kLargestForce && !std::isinf(value)) {
    refuseValue(element, "must be from -" + textOf(kLargestForce) + " to " + textOf(kLargestForce) + " " + unit_);
  }
  return value;
}

std::string Parameter::word(const Element& element) const {
  if (words_.empty() || std::ranges::find(words_, element.text) != words_.end()) return element.text;
  std::string known;
  for (const std::string& each : words_) known += (known.empty() ? "'" : ", '") + each + "'";
  throw Error({Severity::kError, element.position, "<" + name_ + "> is '" + element.text + "'", "it can be " + known});
}

void Declaration::is(std::string text, Place place) {
  text_ = std::move(text);
  place_ = place;
}

Parameter& Declaration::parameter(std::string name, Parameter::Target target, std::string unit, std::string text) {
  return parameters_.emplace_back(std::move(name), target, std::move(unit), std::move(text));
}

Parameter& Declaration::element(std::string name, std::string text) {
  return parameters_.emplace_back(std::move(name), std::monostate(), "", std::move(text));
}

void Declaration::publishes(std::string topic, std::string type, std::string text) {
  endpoints_.push_back({Endpoint::Kind::kPublished, std::move(topic), std::move(type), {}, std::move(text)});
}

void Declaration::subscribes(std::string topic, std::string type, std::string text) {
  endpoints_.push_back({Endpoint::Kind::kSubscribed, std::move(topic), std::move(type), {}, std::move(text)});
}

void Declaration::serves(std::string service, std::string requestType, std::string replyType, std::string text) {
  endpoints_.push_back(
      {Endpoint::Kind::kService, std::move(service), std::move(requestType), std::move(replyType), std::move(text)});
}

bool Declaration::read(const Element& plugin, std::string_view system, Diagnostics& diagnostics) const {
  bool isGood = true;
  for (const Parameter& parameter : parameters_) {
    try {
      parameter.read(plugin);
    } catch (const Error& error) {
      const Diagnostic& found = error.diagnostic();
      diagnostics.warning(found.position, std::string(system) + " is left out: " + found.message, found.hint);
      isGood = false;
    }
  }
  warnOfUnknown(plugin, system, diagnostics);
  return isGood;
}

void Declaration::warnOfUnknown(const Element& plugin, std::string_view system, Diagnostics& diagnostics) const {
  // without a declaration it is not known which parameters a system reads
  if (text_.empty() && parameters_.empty()) return;
  // a parameter "*" stands for all others, which the system hands on
  if (std::ranges::find(parameters_, "*", &Parameter::name) != parameters_.end()) return;
  for (const Element& element : plugin.children) {
    // names with a prefix, such as "my:speed", are extensions for other programs
    if (std::ranges::find(parameters_, element.name, &Parameter::name) != parameters_.end() ||
        element.name.find(':') != std::string::npos) {
      continue;
    }
    std::vector<std::string_view> known;
    for (const Parameter& parameter : parameters_) known.push_back(parameter.name());
    std::string hint = base::didYouMean(element.name, known);
    if (known.empty()) hint = "it has no parameters";
    diagnostics.warning(element.position, std::string(system) + " does not know <" + element.name + ">", hint);
  }
}

}  // namespace pongsim
