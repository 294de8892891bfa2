#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "pongsim/message.hh"
#include "pongsim/messages/field_path.hh"

namespace pongsim::cli {

/// A condition on a value in a message, as written by a user: `pose.position.x >= 1.5`, `name == wall`.
struct FieldCondition {
  enum class Comparison { kEqual, kUnequal, kLess, kAtMost, kMore, kAtLeast };

  std::string path;
  Comparison comparison = Comparison::kEqual;
  std::string value;

  /// @throws UsageError if `text` is not a path, comparison and value.
  static FieldCondition parse(std::string_view text);
};

/// A condition on messages of one type.
class FieldCheck {
 public:
  /// @return The check; if the condition does not fit the type, nothing, with the reason in `error`.
  static std::optional<FieldCheck> make(const FieldCondition& condition, const std::string& type, MessageError& error);

  /// @return Whether the message meets it; false if it has no such value.
  bool isMetBy(const Message& message) const;

 private:
  FieldCheck(FieldPath path, FieldCondition condition);
  FieldPath path_;
  FieldCondition condition_;
  /// The value to compare with, if it is a number.
  double number_ = 0;
};

}  // namespace pongsim::cli
