#include "web/world/message_form.hh"

#include <google/protobuf/message.h>
#include <google/protobuf/util/json_util.h>

#include <climits>

namespace pongsim::web {

std::variant<MessagePointer, std::string> readMessage(std::string_view type, MessageForm form,
                                                      std::span<const std::byte> bytes) {
  MessagePointer message = newMessage(type);
  if (!message) return "there is no message type '" + std::string(type) + "'";
  if (bytes.size() > INT_MAX) return std::to_string(bytes.size()) + " bytes are too many";
  const auto* text = reinterpret_cast<const char*>(bytes.data());
  if (form == MessageForm::kProtobuf) {
    if (message->ParseFromArray(text, static_cast<int>(bytes.size()))) return message;
    return std::to_string(bytes.size()) + " bytes are not of type " + message->GetTypeName();
  }
  const auto status = google::protobuf::util::JsonStringToMessage({text, bytes.size()}, message.get());
  if (status.ok()) return message;
  return "this JSON is not of type " + message->GetTypeName() + ": " + std::string(status.message());
}

std::string writeMessage(const Message& message, MessageForm form) {
  if (form == MessageForm::kProtobuf) return message.SerializeAsString();
  google::protobuf::util::JsonPrintOptions options;
  options.always_print_primitive_fields = true;
  options.preserve_proto_field_names = true;
  std::string json;
  // fails only for Any with an unknown type, which ignition.msgs does not contain
  if (!google::protobuf::util::MessageToJsonString(message, &json, options).ok()) return "{}";
  return json;
}

}  // namespace pongsim::web
