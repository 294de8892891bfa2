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

/// A value inside the messages of one type, by its path: `pose.position.x`, `pose[0].name`, `header.stamp`.
class PONGSIM_API FieldPath {
 public:
  /// @param type Full name of the message type.
  /// @return The path, or what is wrong with it (line 1, the column of the name) in `error`.
  static std::optional<FieldPath> parse(const std::string& type, std::string_view path, MessageError& error);

  /// As the other, for a type that need not be one of those that `newMessage` knows. It must outlive the path.
  static std::optional<FieldPath> parse(const google::protobuf::Descriptor& type, std::string_view path,
                                        MessageError& error);

  const std::string& text() const { return text_; }

  /// @return Whether it leads to one number (a boolean counts as 0 or 1).
  bool isNumber() const;

  /// @return The number there: the field's default where it is not set; nothing where a list is too short.
  /// Only for `isNumber`.
  std::optional<double> numberIn(const Message& message) const;

  /// @return The value in protobuf's text format on one line, a string without its quotes, all of a list as `[a, b]`;
  /// nothing where a list is too short.
  std::optional<std::string> valueIn(const Message& message) const;

 private:
  struct Step {
    const google::protobuf::FieldDescriptor* field;
    /// Which one of a list; negative: all of it, or no list.
    int index = -1;
  };

  /// @return The message that has the last field, or null where a list is too short.
  const Message* ownerIn(const Message& message) const;

  std::string text_;
  std::vector<Step> steps_;
};

/// @return The paths of all single numbers, texts and booleans in messages of that type, in the order of the
/// definition, with lists and the headers of inner messages left out; of the first 100,000 fields.
PONGSIM_API std::vector<std::string> scalarPaths(const std::string& type);
PONGSIM_API std::vector<std::string> scalarPaths(const google::protobuf::Descriptor& type);

}  // namespace pongsim
