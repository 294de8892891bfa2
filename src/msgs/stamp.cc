#include "msgs/stamp.hh"

#include <google/protobuf/message.h>
#include <ignition/msgs/clock.pb.h>
#include <ignition/msgs/header.pb.h>

#include "msgs/time.hh"

namespace pongsim::msgs {

namespace {

/// @return The field, where it is an ignition.msgs.Header.
const google::protobuf::FieldDescriptor* headerField(const Message& message) {
  const google::protobuf::FieldDescriptor* const field = message.GetDescriptor()->FindFieldByName("header");
  const bool isHeader =
      field != nullptr && !field->is_repeated() && field->message_type() == ignition::msgs::Header::descriptor();
  return isHeader ? field : nullptr;
}

}  // namespace

bool hasStamp(std::string_view type) {
  const MessagePointer message = newMessage(type);
  return message != nullptr && headerField(*message) != nullptr;
}

std::optional<Time> stampOf(const Message& message) {
  const google::protobuf::FieldDescriptor* const field = headerField(message);
  if (field == nullptr) return std::nullopt;
  const auto& header = static_cast<const ignition::msgs::Header&>(message.GetReflection()->GetMessage(message, field));
  if (!header.has_stamp()) return std::nullopt;
  return timeOf(header.stamp());
}

ClockReading clockReading(const Message& clock) {
  const auto& message = static_cast<const ignition::msgs::Clock&>(clock);
  return {timeOf(message.sim()), timeOf(message.system())};
}

}  // namespace pongsim::msgs
