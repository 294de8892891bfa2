#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "pongsim/message.hh"

namespace pongsim::web {

/// In what form a message is on the wire.
enum class MessageForm { kProtobuf, kJson };

/// @param type Of a message: any of the names that `messageTypeName` knows.
/// @param bytes From a client; may be anything.
/// @return The message, or what is wrong with it, as the end of a sentence: "12 bytes are not of type
/// ignition.msgs.Twist".
std::variant<MessagePointer, std::string> readMessage(std::string_view type, MessageForm form,
                                                      std::span<const std::byte> bytes);

/// @return The message in that form; its JSON has all fields, also those of default value.
std::string writeMessage(const Message& message, MessageForm form);

}  // namespace pongsim::web
