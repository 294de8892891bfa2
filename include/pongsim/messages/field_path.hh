#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pongsim/export.hh"
#include "pongsim/message.hh"

namespace google::protobuf {
class Descriptor;
class FieldDescriptor;
}  // namespace google::protobuf

namespace pongsim {

/// Path to a value in messages of one type: `pose.position.x`, `pose[0].name`, `header.stamp`.
class PONGSIM_API FieldPath {
 public:
  /// @param type Full name of the message type.
  /// @return The path; nothing on an error, which is in `error` (line 1, the column of the name).
  static std::optional<FieldPath> parse(const std::string& type, std::string_view path, MessageError& error);

  /// The same for a type that `newMessage` need not know. It must outlive the path.
  static std::optional<FieldPath> parse(const google::protobuf::Descriptor& type, std::string_view path,
                                        MessageError& error);

  const std::string& text() const { return text_; }

  /// @return Whether the value is a single number (a boolean counts as 0 or 1).
  bool isNumber() const;

  /// @return The number: the field's default if it is not set, nothing if a list is too short. Only if `isNumber`.
  std::optional<double> numberIn(const Message& message) const;

  /// @return Whether the value is a whole list of numbers.
  bool isNumberList() const;

  /// @return The numbers of a list; none if an outer list is too short. Only if `isNumberList`.
  std::vector<double> numbersIn(const Message& message) const;

  /// @return The value in protobuf's text format on one line, strings without quotes, a whole list as `[a, b]`; nothing
  /// if a list is too short.
  std::optional<std::string> valueIn(const Message& message) const;

 private:
  struct Step {
    const google::protobuf::FieldDescriptor* field;
    /// Index in a list; negative: the whole list, or not a list.
    int index = -1;
  };

  /// @return The message with the last field, or null if a list is too short.
  const Message* ownerIn(const Message& message) const;

  std::string text_;
  std::vector<Step> steps_;
};

/// @return The paths of all single numbers, strings and booleans in messages of a type, in the order of the definition,
/// without lists and headers of inner messages; among the first 100,000 fields.
PONGSIM_API std::vector<std::string> scalarPaths(const std::string& type);
PONGSIM_API std::vector<std::string> scalarPaths(const google::protobuf::Descriptor& type);

}  // namespace pongsim
