#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "pongsim/message.hh"
#include "pongsim/messages/field_path.hh"

namespace pongsim::cli {

/// A condition on one value of a message, as a user writes it: `pose.position.x >= 1.5`, `name == wall`.
struct FieldCondition {
  enum class Comparison { kEqual, kUnequal, kLess, kAtMost, kMore, kAtLeast };

  std::string path;
  Comparison comparison = Comparison::kEqual;
  std::string value;

  /// @throws UsageError where `text` is no path, comparison and value.
  static FieldCondition parse(std::string_view text);
};

/// A condition on messages of one type.
class FieldCheck {
 public:
  /// @return The check, or what is wrong with the condition for that type in `error`.
  static std::optional<FieldCheck> make(const FieldCondition& condition, const std::string& type, MessageError& error);

  /// @return Whether the message meets it; false where it has no such value.
  bool isMetBy(const Message& message) const;

 private:
  FieldCheck(FieldPath path, FieldCondition condition);
  FieldPath path_;
  FieldCondition condition_;
  /// The wanted value where it is a number.
  double number_ = 0;
};

}  // namespace pongsim::cli
