#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace pongsim::cli {

/// The allowed values of an extension's option, from its descriptor.
class ExtensionValue {
 public:
  /// Any text.
  ExtensionValue() = default;
  /// @param option With "type" ("text", "number" or "whole number"), "least", "most" and "words", all optional.
  /// @throws std::runtime_error if they contradict each other, nlohmann::json::exception if they have the wrong type.
  explicit ExtensionValue(const nlohmann::json& option);

  bool isNumber() const { return type_ != Type::kText; }

  /// @return Whether some texts are not allowed.
  bool isLimited() const { return type_ != Type::kText || !words_.empty(); }

  /// @param name The option: "--x-rate".
  /// @throws UsageError if `text` is not allowed, with what is.
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
