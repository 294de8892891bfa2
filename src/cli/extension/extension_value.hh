#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace pongsim::cli {

/// What the value of an extension's option may be, as its descriptor says it.
class ExtensionValue {
 public:
  /// Any text.
  ExtensionValue() = default;
  /// @param option With "type" ("text", "number" or "whole number"), "least", "most" and "words", each of which may be
  /// left out.
  /// @throws std::runtime_error where they do not go together, nlohmann::json::exception where they are something else.
  explicit ExtensionValue(const nlohmann::json& option);

  bool isNumber() const { return type_ != Type::kText; }

  /// @return Whether there is a text that it is not.
  bool isLimited() const { return type_ != Type::kText || !words_.empty(); }

  /// @param name The option: "--x-rate".
  /// @throws UsageError where `text` is no such value, saying what is.
  void check(const std::string& name, const std::string& text) const;

 private:
  enum class Type { kText, kNumber, kWholeNumber };

  bool takes(const std::string& text) const;
  /// @return "a number from 0".
  std::string description() const;

  Type type_ = Type::kText;
  std::optional<double> least_, most_;
  std::vector<std::string> words_;
};

}  // namespace pongsim::cli
