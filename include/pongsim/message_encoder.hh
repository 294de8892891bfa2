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

/// Messages of topics in the encoding of others, as a package beside pongsim has it, for who writes them into files.
namespace pongsim {

/// A topic in another encoding.
struct EncodedTopic {
  /// "/scan"
  std::string name;
  /// "sensor_msgs/msg/LaserScan"
  std::string type;
  /// That of its messages: "cdr".
  std::string messageEncoding;
  /// What describes the type, and in which language: "ros2msg".
  std::string schemaEncoding;
  std::string schema;
  /// What readers of that encoding want to know besides, by the names that they have for it.
  std::map<std::string, std::string> metadata;
};

/// Turns the messages of one topic into another encoding. For one thread at a time.
class PONGSIM_API TopicEncoder {
 public:
  /// Called with a payload and the place of its topic in `topics`. The payload lives until it returns.
  using Take = std::function<void(std::size_t topic, std::span<const std::byte> payload)>;

  virtual ~TopicEncoder();

  /// @return What the topic becomes: one topic, or several that get each message.
  virtual const std::vector<EncodedTopic>& topics() const = 0;

  /// @param message In protobuf's binary form.
  /// @param take Called once for each of `topics`.
  /// @throws std::runtime_error where the bytes are no message of the topic's type, as the end of a sentence: "12 bytes
  /// are no ignition.msgs.Twist"; and what `take` throws.
  virtual void encode(std::span<const std::byte> message, const Take& take) = 0;
};

/// Turns the topics of a recording into another encoding. For one thread at a time.
class PONGSIM_API MessageEncoder {
 public:
  virtual ~MessageEncoder();

  /// @return What MCAP calls the profile of a file with such topics: "ros2".
  virtual std::string_view profile() const = 0;

  /// @param type Full name of the messages' type.
  /// @return What turns the topic's messages, there no longer than this; or why there is nothing in the other encoding
  /// that the topic could be, as the end of a sentence: "ignition.msgs.Scene has no partner in ROS".
  virtual std::variant<std::unique_ptr<TopicEncoder>, std::string> openTopic(std::string_view topic,
                                                                             std::string_view type) = 0;
};

/// What an encoder is to know, by the names that it has for it.
using EncoderSettings = std::map<std::string, std::string>;

/// @param name The short name of the library that has it: "ros2" is that of `libpongsim-ros2-system.so`, which is
/// looked for where those of systems are.
/// @return A new encoder; null where there is none or the settings are wrong, and then `diagnostics` says why.
PONGSIM_API std::unique_ptr<MessageEncoder> makeMessageEncoder(std::string_view name, const EncoderSettings& settings,
                                                               Diagnostics& diagnostics);

/// What a library exports beside its systems, under the name `pongsim_encoder`. The table of the systems has the
/// version.
struct EncoderTable {
  /// As `makeMessageEncoder`.
  std::unique_ptr<MessageEncoder> (*make)(const EncoderSettings& settings, Diagnostics& diagnostics);
};

}  // namespace pongsim

/// Exports an encoder from the library of a system, by the function that makes it. Once a library.
#define PONGSIM_EXPORT_ENCODER(make)                                    \
  extern "C" PONGSIM_API const ::pongsim::EncoderTable pongsim_encoder; \
  const ::pongsim::EncoderTable pongsim_encoder { make }
