#include <google/protobuf/descriptor.h>
#include <google/protobuf/io/tokenizer.h>
#include <google/protobuf/io/zero_copy_stream_impl_lite.h>
#include <google/protobuf/message.h>
#include <google/protobuf/text_format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "base/nearest_word.hh"
#include "base/text.hh"
#include "msgs/encoding/text_context.hh"
#include "msgs/types/type_source.hh"
#include "pongsim/message.hh"

namespace pongsim {

namespace {

namespace protobuf = google::protobuf;
using msgs::TextContext;
using msgs::TokenPosition;

/// The nesting limit of protobuf's binary parser.
constexpr int kDeepestNesting = 100;
/// Maximum length of user text quoted in a message.
constexpr std::size_t kLongestQuote = 60;

/// Keeps the first error, because the following ones are mostly consequences.
class FirstError : public protobuf::io::ErrorCollector {
 public:
  void AddError(int line, int column, const std::string& message) override {
    if (found) return;
    found = true;
    position = {line, column};
    complaint = message;
  }

  bool found = false;
  TokenPosition position;
  std::string complaint;
};

/// @return `part` in quotes, on one line and of limited length.
std::string quote(std::string_view part) {
  std::string shown(part.substr(0, kLongestQuote));
  if (part.size() > kLongestQuote) shown += "...";
  std::replace_if(
      shown.begin(), shown.end(), [](char letter) { return static_cast<unsigned char>(letter) < ' '; }, ' ');
  const bool quoted = part.starts_with('"') || part.starts_with('\'');
  return quoted ? shown : "'" + shown + "'";
}

/// @return The text in the `index`th pair of double quotes in protobuf's error message.
std::string_view quotedPart(std::string_view complaint, int index) {
  std::size_t begin = 0;
  for (int passed = 0; passed < 2 * index + 1; ++passed) begin = complaint.find('"', begin) + 1;
  return complaint.substr(begin, complaint.find('"', begin) - begin);
}

std::string_view after(std::string_view complaint, std::string_view mark) {
  const std::size_t found = complaint.find(mark);
  return found == std::string_view::npos ? std::string_view() : complaint.substr(found + mark.size());
}

std::vector<std::string_view> valuesOf(const protobuf::EnumDescriptor& type) {
  std::vector<std::string_view> values;
  for (int i = 0; i < type.value_count(); ++i) values.push_back(type.value(i)->name());
  return values;
}

std::vector<std::string_view> fieldsOf(const protobuf::Descriptor& type) {
  std::vector<std::string_view> fields;
  for (int i = 0; i < type.field_count(); ++i) fields.push_back(type.field(i)->name());
  return fields;
}

/// @return A user-friendly name for the kind of value a field takes.
std::string kindOf(const protobuf::FieldDescriptor& field) {
  switch (field.cpp_type()) {
    case protobuf::FieldDescriptor::CPPTYPE_BOOL:
      return "true or false";
    case protobuf::FieldDescriptor::CPPTYPE_DOUBLE:
    case protobuf::FieldDescriptor::CPPTYPE_FLOAT:
      return "a number";
    case protobuf::FieldDescriptor::CPPTYPE_ENUM:
      return "one of " + base::listed(valuesOf(*field.enum_type()));
    case protobuf::FieldDescriptor::CPPTYPE_STRING:
      return "text in quotes";
    case protobuf::FieldDescriptor::CPPTYPE_MESSAGE:
      return "{...} with the fields of " + field.message_type()->full_name();
    case protobuf::FieldDescriptor::CPPTYPE_UINT32:
    case protobuf::FieldDescriptor::CPPTYPE_UINT64:
      return "a whole number from 0";
    default:
      return "a whole number";
  }
}

MessageError saying(std::string message) {
  MessageError error;
  error.message = std::move(message);
  return error;
}

MessageError unknownField(std::string_view typeName, std::string_view field) {
  MessageError error = saying("field " + quote(field) + " is not in " + std::string(typeName));
  const protobuf::Descriptor* type = msgs::typeSource().pool.FindMessageTypeByName(std::string(typeName));
  if (type == nullptr) return error;
  const std::vector<std::string_view> known = fieldsOf(*type);
  // names of one or two letters are all similar to each other
  if (field.size() > 2) error.hint = base::didYouMean(field, known);
  if (error.hint.empty()) error.hint = known.empty() ? "it has no fields" : "its fields: " + base::listed(known);
  return error;
}

MessageError unknownEnumValue(std::string_view value, std::string_view name, const TextContext& context) {
  MessageError error = saying(quote(value) + " is not a value of field " + quote(name));
  if (context.field == nullptr || context.field->enum_type() == nullptr) return error;
  const std::vector<std::string_view> known = valuesOf(*context.field->enum_type());
  error.hint = base::didYouMean(value, known);
  error.hint += (error.hint.empty() ? "" : " ") + ("its values: " + base::listed(known));
  return error;
}

MessageError wrongValue(std::string_view found, const TextContext& context) {
  const protobuf::FieldDescriptor* field = context.field;
  if (field == nullptr) return saying(quote(found) + " is not allowed here");
  const std::string name = quote(field->name());
  if (found.empty()) return saying("the text ends before the value of field " + name);
  if (found == "[" && !field->is_repeated()) return saying("field " + name + " takes one value, not a list");
  return saying("field " + name + " takes " + kindOf(*field) + ", not " + quote(found));
}

MessageError wrongSymbol(std::string_view expected, std::string_view found, const TextContext& context) {
  if (expected == "{" || expected == "<") return wrongValue(found, context);
  if (found.empty()) return saying("the text ends before a " + quote(expected));
  return saying(quote(expected) + " expected here, not " + quote(found));
}

MessageError wrongName(std::string_view found, const TextContext& context) {
  if (found.empty() && !context.opener.empty()) {
    return saying("the text ends before the '}' of field " + quote(context.opener));
  }
  if (found.empty()) return saying("the text ends before a field's name");
  if (context.opener.empty() && found == "}") return saying("'}' without '{'");
  return saying("a field's name expected here, not " + quote(found));
}

/// Translates protobuf's error message for users. Unknown messages are passed on unchanged.
MessageError explain(std::string_view complaint, const TextContext& context, TokenPosition& blamed) {
  const auto says = [complaint](std::string_view beginning) { return complaint.starts_with(beginning); };
  if (says("Message type \"")) {
    blamed = context.lastName;
    return unknownField(quotedPart(complaint, 0), quotedPart(complaint, 1));
  }
  if (says("Unknown enumeration value")) {
    blamed = context.lastValue;
    return unknownEnumValue(quotedPart(complaint, 0), quotedPart(complaint, 1), context);
  }
  if (says("Invalid value for boolean field")) {
    blamed = context.lastValue;
    return wrongValue(quotedPart(complaint, 1), context);
  }
  if (says("Non-repeated field")) {
    blamed = context.lastName;
    return saying("field " + quote(quotedPart(complaint, 0)) + " is set twice but takes one value");
  }
  if (says("Expected identifier, got: ")) return wrongName(after(complaint, "got: "), context);
  if (says("Expected \"")) return wrongSymbol(quotedPart(complaint, 0), quotedPart(complaint, 1), context);
  if (says("Expected ")) return wrongValue(after(complaint, "got: "), context);
  if (says("Integer out of range (")) {
    std::string_view number = after(complaint, "(");
    number.remove_suffix(1);
    if (context.field == nullptr || context.field->cpp_type() == protobuf::FieldDescriptor::CPPTYPE_BOOL) {
      return wrongValue(number, context);
    }
    return saying(quote(number) + " is out of range for field " + quote(context.field->name()) + " (" +
                  context.field->type_name() + ")");
  }
  if (says("Message is too deep")) {
    return saying("the messages are nested more than " + std::to_string(kDeepestNesting) + " deep");
  }
  if (says("Unexpected end of string")) return saying("the string has no closing quote");

  std::string message(complaint.substr(0, complaint.find_last_not_of('.') + 1));
  if (!message.empty() && message[0] >= 'A' && message[0] <= 'Z')
    message[0] = static_cast<char>(message[0] - 'A' + 'a');
  return saying(message);
}

/// @return The tokenizer's `column`, which expands tabs, as a column counted in bytes from 1.
int byteColumn(std::string_view text, TokenPosition position) {
  constexpr int kTabWidth = 8;
  std::size_t at = 0;
  for (int line = 0; line < position.line; ++line) at = std::min(text.find('\n', at), text.size() - 1) + 1;
  const std::size_t begin = at;
  for (int column = 0; column < position.column && at < text.size(); ++at) {
    column += text[at] == '\t' ? kTabWidth - column % kTabWidth : 1;
  }
  return static_cast<int>(at - begin) + 1;
}

/// Protobuf accepts any bytes for a string in text format, but rejects invalid UTF-8 in the binary payload made from
/// it.
bool survivesTheWire(const Message& message) {
  const std::unique_ptr<Message> copy(message.New());
  return copy->ParseFromString(message.SerializeAsString());
}

}  // namespace

std::optional<MessageError> parseMessage(std::string_view text, Message& message) {
  if (text.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    return saying("the text is larger than 2 GiB");
  }
  FirstError first;
  protobuf::TextFormat::Parser parser;
  parser.RecordErrorsTo(&first);
  parser.SetRecursionLimit(kDeepestNesting);
  protobuf::io::ArrayInputStream stream(text.data(), static_cast<int>(text.size()));
  const bool parsed = parser.Parse(&stream, &message);
  if (parsed && !first.found) {
    const bool plain =
        std::all_of(text.begin(), text.end(), [](unsigned char letter) { return letter < 0x80 && letter != '\\'; });
    if (plain || survivesTheWire(message)) return std::nullopt;
    return saying("a string is not valid UTF-8");
  }

  const TextContext context = msgs::contextOf(text, *message.GetDescriptor(), first.position);
  TokenPosition position = first.position;
  MessageError error = explain(first.complaint, context, position);
  error.line = position.line + 1;
  error.column = byteColumn(text, position);
  return error;
}

}  // namespace pongsim
