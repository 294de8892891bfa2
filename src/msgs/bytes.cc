#include "msgs/bytes.hh"

#include <google/protobuf/message.h>

#include <limits>

namespace pongsim::msgs {

const std::string& typeName(const Message& message) { return message.GetDescriptor()->full_name(); }

std::size_t byteSize(const Message& message) { return message.ByteSizeLong(); }

void writeBytes(const Message& message, std::span<std::byte> place) {
  message.SerializeWithCachedSizesToArray(reinterpret_cast<std::uint8_t*>(place.data()));
}

bool parseBytes(std::span<const std::byte> bytes, Message& message) {
  if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) return false;
  return message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()));
}

}  // namespace pongsim::msgs
