#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "pongsim/export.hh"
#include "pongsim/message.hh"
#include "pongsim/messages/message_encoder.hh"

namespace pongsim {

/// Converts messages in another encoding to those of a topic. Not thread-safe.
class PONGSIM_API TopicDecoder {
 public:
  virtual ~TopicDecoder() = default;

  /// @return How they are encoded; without a name.
  virtual const EncodedTopic& encoding() const = 0;

  /// @return Full name of the type of the topic's messages.
  virtual std::string messageType() const = 0;

  /// @return The message, valid until the next call.
  /// @throws std::runtime_error with the reason, if the payload is invalid or would be refused as a command.
  virtual const Message& decode(std::span<const std::byte> payload) = 0;
};

/// A `MessageEncoder` that also reads what it has written is one of these, too: `dynamic_cast` tells. Not thread-safe.
class PONGSIM_API MessageDecoder {
 public:
  virtual ~MessageDecoder() = default;

  /// @param encodedType Type in the other encoding: "geometry_msgs/msg/Twist".
  /// @param type Full name of the type of the topic's messages; empty: the usual one for the other type.
  /// @return The decoder; or why there is none, as a sentence without a full stop.
  virtual std::variant<std::unique_ptr<TopicDecoder>, std::string> openInput(std::string_view encodedType,
                                                                             std::string_view type) = 0;
};

}  // namespace pongsim
