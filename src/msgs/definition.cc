#include "msgs/definition.hh"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include "pongsim/message.hh"

namespace pongsim::msgs {

std::optional<std::string> definition(std::string_view name) {
  const MessagePointer message = newMessage(name);
  if (!message) return std::nullopt;
  return message->GetDescriptor()->DebugString();
}

}  // namespace pongsim::msgs
