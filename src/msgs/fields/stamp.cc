#include "msgs/fields/stamp.hh"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <algorithm>
#include <chrono>

#include "msgs/fields/field_reader.hh"

namespace pongsim::msgs {

namespace {

/// @return The field, if it is an ignition.msgs.Header.
const google::protobuf::FieldDescriptor* headerField(const Message& message) {
  const google::protobuf::FieldDescriptor* const field = message.GetDescriptor()->FindFieldByName("header");
  const bool isHeader = field != nullptr && !field->is_repeated() && field->message_type() != nullptr &&
                        field->message_type()->full_name() == "ignition.msgs.Header";
  return isHeader ? field : nullptr;
}

Time timeIn(const FieldReader& reader) { return timeOf(reader.whole("sec"), reader.whole("nsec")); }

}  // namespace

Time timeOf(std::int64_t seconds, std::int64_t nanoseconds) {
  constexpr std::int64_t kLargest = 146LL * 365 * 86400;
  return std::chrono::seconds(std::clamp(seconds, -kLargest, kLargest)) + std::chrono::nanoseconds(nanoseconds);
}

bool hasStamp(std::string_view type) {
  const MessagePointer message = newMessage(type);
  return message != nullptr && headerField(*message) != nullptr;
}

std::optional<Time> stampOf(const Message& message) {
  const google::protobuf::FieldDescriptor* const field = headerField(message);
  if (field == nullptr) return std::nullopt;
  const Message& header = message.GetReflection()->GetMessage(message, field);
  const auto* stamp = header.GetDescriptor()->FindFieldByName("stamp");
  if (!header.GetReflection()->HasField(header, stamp)) return std::nullopt;
  return timeIn(FieldReader(header).inside("stamp"));
}

ClockReading clockReading(const Message& clock) {
  const FieldReader reader(clock);
  return {timeIn(reader.inside("sim")), timeIn(reader.inside("system"))};
}

}  // namespace pongsim::msgs
