#include "cli/extension/extension_value.hh"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>

#include "base/parse_number.hh"
#include "cli/options/number_option.hh"
#include "pongsim/program/nearest_word.hh"
#include "shared/program/failure.hh"

namespace pongsim::cli {

namespace {

std::optional<double> bound(const nlohmann::json& option, const char* name) {
  const auto found = option.find(name);
  return found == option.end() ? std::nullopt : std::optional(found->get<double>());
}

}  // namespace

ExtensionValue::ExtensionValue(const nlohmann::json& option)
    : least_(bound(option, "least")),
      most_(bound(option, "most")),
      words_(option.value("words", std::vector<std::string>())) {
  const std::string type = option.value("type", "text");
  if (type == "number") {
    type_ = Type::kNumber;
  } else if (type == "whole number") {
    type_ = Type::kWholeNumber;
  } else if (type != "text") {
    throw std::runtime_error("a value must be text, a number or a whole number, not '" + type + "'");
  }
  if (type_ == Type::kText && (least_ || most_)) throw std::runtime_error("text has no minimum and maximum");
  if (type_ != Type::kText && !words_.empty()) throw std::runtime_error("a number has no list of words");
}

void ExtensionValue::check(const std::string& name, const std::string& text) const {
  if (takes(text)) return;
  const std::string problem = "option '" + name + "' takes " + description() + ", not '" + text + "'";
  throw UsageError(problem, didYouMean(text, std::vector<std::string_view>(words_.begin(), words_.end())));
}

bool ExtensionValue::takes(const std::string& text) const {
  if (type_ == Type::kText) return words_.empty() || std::ranges::find(words_, text) != words_.end();
  if (type_ == Type::kWholeNumber && !base::parseInteger(text)) return false;
  const std::optional<double> value = base::parseDouble(text);
  return value && std::isfinite(*value) && (!least_ || *value >= *least_) && (!most_ || *value <= *most_);
}

std::string ExtensionValue::description() const {
  if (type_ == Type::kText) {
    std::string list;
    for (const std::string& word : words_) list += (list.empty() ? "'" : ", '") + word + "'";
    return words_.size() == 1 ? list : "one of " + list;
  }
  std::string text = type_ == Type::kNumber ? "a number" : "a whole number";
  if (least_) text += " from " + shortNumber(*least_);
  if (most_) text += (least_ ? " to " : " up to ") + shortNumber(*most_);
  return text;
}

}  // namespace pongsim::cli
