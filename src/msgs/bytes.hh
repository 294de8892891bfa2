#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "pongsim/message.hh"

namespace pongsim::msgs {

/// @return The full name of the message's type.
const std::string& typeName(const Message& message);

/// @return How many bytes `writeBytes` writes.
std::size_t byteSize(const Message& message);

/// Writes the message in protobuf's binary form, at once after `byteSize`, whose result is the size of `place`.
void writeBytes(const Message& message, std::span<std::byte> place);

/// Replaces `message` by what the bytes say.
/// @return Whether they are a message of its type.
bool parseBytes(std::span<const std::byte> bytes, Message& message);

}  // namespace pongsim::msgs
