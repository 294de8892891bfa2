#include "msgs/encoding/message_template.hh"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <algorithm>
#include <vector>

#include "pongsim/message.hh"

namespace pongsim::msgs {

namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;

std::string defaultOf(const FieldDescriptor& field) {
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_STRING:
      return "\"\"";
    case FieldDescriptor::CPPTYPE_BOOL:
      return "false";
    case FieldDescriptor::CPPTYPE_ENUM:
      return field.default_value_enum()->name();
    default:
      return "0";
  }
}

/// @param open The types that enclose this one.
void add(const Descriptor& type, const std::string& indentation, std::vector<const Descriptor*>& open,
         std::string& text) {
  open.push_back(&type);
  for (int i = 0; i < type.field_count(); ++i) {
    const FieldDescriptor& field = *type.field(i);
    const Descriptor* inner = field.message_type();
    const bool isChoice = field.containing_oneof() != nullptr;
    const bool isEndless = inner != nullptr && std::find(open.begin(), open.end(), inner) != open.end();
    if (field.is_repeated() || isChoice || isEndless) {
      text += indentation + "# " + field.name() + (inner != nullptr ? " { ... }" : ": " + defaultOf(field));
      if (field.is_repeated()) text += "  (any number of them)";
      if (isChoice) text += "  (at most one for " + field.containing_oneof()->name() + ")";
      text += "\n";
    } else if (inner == nullptr) {
      text += indentation + field.name() + ": " + defaultOf(field) + "\n";
    } else {
      text += indentation + field.name() + " {\n";
      add(*inner, indentation + "  ", open, text);
      text += indentation + "}\n";
    }
  }
  open.pop_back();
}

}  // namespace

std::optional<std::string> messageTemplate(std::string_view name) {
  const MessagePointer message = newMessage(name);
  if (!message) return std::nullopt;
  std::string text;
  std::vector<const Descriptor*> open;
  add(*message->GetDescriptor(), "", open, text);
  return text;
}

}  // namespace pongsim::msgs
