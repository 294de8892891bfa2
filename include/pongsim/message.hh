#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pongsim/export.hh"

namespace google::protobuf {
class Message;
}

namespace pongsim {

using Message = google::protobuf::Message;

/// Deletes a message whose class is incomplete.
struct PONGSIM_API MessageDeleter {
  void operator()(Message* message) const;
};
using MessagePointer = std::unique_ptr<Message, MessageDeleter>;

/// What is wrong with a message's text, and where. Line and column count from 1; 0: unknown.
struct MessageError {
  int line = 0;
  int column = 0;
  std::string message;
  /// One line with a hint ("did you mean 'linear'?"), or empty.
  std::string hint;
};

/// @return The full name of a message type, or nothing if there is no such type. `ignition.msgs.X`, `.ignition.msgs.X`,
/// `ign_msgs.X`, `gz.msgs.X` and `X` all name `ignition.msgs.X`.
PONGSIM_API std::optional<std::string> messageTypeName(std::string_view name);

/// @return The full name of the type with the most similar name, or an empty text if none is similar.
PONGSIM_API std::string nearestMessageType(std::string_view name);

/// @return The full names of all types, sorted.
PONGSIM_API std::vector<std::string> messageTypes();

/// @return An empty message of the type named `name`, or null if there is no such type.
PONGSIM_API MessagePointer newMessage(std::string_view name);

/// Replaces `message` by the content of `text`, in protobuf's text format: `linear: {x: 0.5}, angular: {z: 0.05}`.
/// @return The error, or nothing. After an error, `message` has the content before it.
PONGSIM_API std::optional<MessageError> parseMessage(std::string_view text, Message& message);

/// @return The message in protobuf's text format, one line per field.
PONGSIM_API std::string messageText(const Message& message);

/// @return The message as one line of JSON in protobuf's mapping (camelCase names, 64-bit integers as strings, fields
/// with default values left out).
PONGSIM_API std::string messageJson(const Message& message);

}  // namespace pongsim
