#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "pongsim/diagnostic.hh"
#include "pongsim/export.hh"

/// Conversion of topics to other encodings, provided by packages beside pongsim, for writing them into files.
namespace pongsim {

/// A topic in another encoding.
struct EncodedTopic {
  /// "/scan"
  std::string name;
  /// "sensor_msgs/msg/LaserScan"
  std::string type;
  /// Encoding of its messages: "cdr".
  std::string messageEncoding;
  /// Language of the type's description: "ros2msg".
  std::string schemaEncoding;
  std::string schema;
  /// Further metadata for readers of that encoding, by its own names.
  std::map<std::string, std::string> metadata;
};

/// Converts the messages of one topic into another encoding. Not thread-safe.
class PONGSIM_API TopicEncoder {
 public:
  /// Called with a payload and the index of its topic in `topics`. The payload is valid during the call.
  using Take = std::function<void(std::size_t topic, std::span<const std::byte> payload)>;

  virtual ~TopicEncoder();

  /// @return The converted topics: one, or several that each get every message.
  virtual const std::vector<EncodedTopic>& topics() const = 0;

  /// @param message In protobuf's binary form.
  /// @param take Called once for each of `topics`.
  /// @throws std::runtime_error if the bytes are not a message of the topic's type, as the end of a sentence: "12 bytes
  /// are not of type ignition.msgs.Twist"; and whatever `take` throws.
  virtual void encode(std::span<const std::byte> message, const Take& take) = 0;
};

/// Converts the topics of a recording into another encoding. Not thread-safe.
class PONGSIM_API MessageEncoder {
 public:
  virtual ~MessageEncoder();

  /// @return The MCAP profile of a file with such topics: "ros2".
  virtual std::string_view profile() const = 0;

  /// @param type Full name of the messages' type.
  /// @return The encoder of the topic, which must not outlive this; or why the topic has no counterpart, as the end of
  /// a sentence: "ignition.msgs.Scene has no counterpart in ROS".
  virtual std::variant<std::unique_ptr<TopicEncoder>, std::string> openTopic(std::string_view topic,
                                                                             std::string_view type) = 0;
};

/// Settings of an encoder, by its own names.
using EncoderSettings = std::map<std::string, std::string>;

/// @param name The short name of the library with the encoder: "ros2" for `libpongsim-ros2-system.so`, which is
/// searched like systems.
/// @return A new encoder; null if there is none or the settings are invalid, with the reason in `diagnostics`.
PONGSIM_API std::unique_ptr<MessageEncoder> makeMessageEncoder(std::string_view name, const EncoderSettings& settings,
                                                               Diagnostics& diagnostics);

/// Exported by a library beside its systems, under the name `pongsim_encoder`. The table of the systems contains the
/// version.
struct EncoderTable {
  /// Like `makeMessageEncoder`.
  std::unique_ptr<MessageEncoder> (*make)(const EncoderSettings& settings, Diagnostics& diagnostics);
};

}  // namespace pongsim

/// Exports an encoder from the library of a system, given the function that makes it. Use once per library.
#define PONGSIM_EXPORT_ENCODER(make)                                    \
  extern "C" PONGSIM_API const ::pongsim::EncoderTable pongsim_encoder; \
  const ::pongsim::EncoderTable pongsim_encoder { make }
