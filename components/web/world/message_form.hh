#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "pongsim/message.hh"

namespace pongsim::web {

/// How a message is serialized.
enum class MessageForm { kProtobuf, kJson };

/// @param type Of a message: any of the names that `messageTypeName` knows.
/// @param bytes From a client; not trusted.
/// @return The message, or what is wrong with it, as the end of a sentence: "12 bytes are not of type
/// ignition.msgs.Twist".
std::variant<MessagePointer, std::string> readMessage(std::string_view type, MessageForm form,
                                                      std::span<const std::byte> bytes);

/// @return The serialized message; in JSON with all fields, including those with default values.
std::string writeMessage(const Message& message, MessageForm form);

}  // namespace pongsim::web
