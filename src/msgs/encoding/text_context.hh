#pragma once

#include <string>
#include <string_view>

namespace google::protobuf {
class Descriptor;
class FieldDescriptor;
}  // namespace google::protobuf

namespace pongsim::msgs {

/// Where a token stands, as protobuf's tokenizer counts: from 0, a tab reaching to the next multiple of 8.
struct TokenPosition {
  int line = 0;
  int column = 0;
  auto operator<=>(const TokenPosition&) const = default;
};

/// What stands before a place in a message's text.
struct TextContext {
  /// The message whose braces are open there; null where an unknown field opened them.
  const google::protobuf::Descriptor* type = nullptr;
  /// The field that was named last in it; null where it is not one of `type`.
  const google::protobuf::FieldDescriptor* field = nullptr;
  /// How the field that opened the braces is called; empty at the top.
  std::string opener;
  /// The name and the value that were read last.
  TokenPosition lastName, lastValue;
};

/// @param end The place; what stands there and after it is not read.
TextContext contextOf(std::string_view text, const google::protobuf::Descriptor& root, TokenPosition end);

}  // namespace pongsim::msgs
