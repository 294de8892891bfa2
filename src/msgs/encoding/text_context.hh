#pragma once

#include <string>
#include <string_view>

namespace google::protobuf {
class Descriptor;
class FieldDescriptor;
}  // namespace google::protobuf

namespace pongsim::msgs {

/// Position of a token as counted by protobuf's tokenizer: from 0, with tab stops at multiples of 8.
struct TokenPosition {
  int line = 0;
  int column = 0;
  auto operator<=>(const TokenPosition&) const = default;
};

/// The context of a position in a message's text.
struct TextContext {
  /// The message whose braces are open there; null if they belong to an unknown field.
  const google::protobuf::Descriptor* type = nullptr;
  /// The last field named in it; null if it is not a field of `type`.
  const google::protobuf::FieldDescriptor* field = nullptr;
  /// Name of the field that opened the braces; empty at the top level.
  std::string opener;
  /// The last name and the last value before the position.
  TokenPosition lastName, lastValue;
};

/// @param end The position; the text from there on is not read.
TextContext contextOf(std::string_view text, const google::protobuf::Descriptor& root, TokenPosition end);

}  // namespace pongsim::msgs
