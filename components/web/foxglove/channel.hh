#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include <nlohmann/json_fwd.hpp>

#include "web/server/session.hh"

namespace pongsim::web::foxglove {

/// Creates the header of a message for a subscription, with this simulated time [ns].
using Head = std::function<std::string(std::uint64_t timeNs)>;

/// A channel that clients can subscribe to.
struct Channel {
  std::string topic;
  /// Encoding of its messages: "protobuf".
  std::string encoding;
  /// Full name of the message type.
  std::string schemaName;
  /// Encoding of the schema: "protobuf"; empty: the same as of the messages.
  std::string schemaEncoding;
  /// As text; binary schemas in base64.
  std::shared_ptr<const std::string> schema;
  /// Distinguishes channels with the same name: a channel with another source is another channel.
  const void* source = nullptr;
  /// Sends messages to the client under this key, until the result is destroyed.
  std::function<std::shared_ptr<void>(const std::shared_ptr<Client>& client, std::uint64_t key, Head head)> open;
  /// See `OwnChannel::ask`; empty for channels that send by themselves.
  std::function<std::string(const std::shared_ptr<void>& opened, const nlohmann::json& wish)> ask = {};

  bool isSame(const Channel& other) const {
    return topic == other.topic && encoding == other.encoding && schemaName == other.schemaName &&
           source == other.source;
  }
};

/// @return A channel with protobuf messages, without `open`.
inline Channel protobufChannel(std::string topic, std::string schemaName, std::shared_ptr<const std::string> schema,
                               const void* source) {
  return {std::move(topic), "protobuf", std::move(schemaName), "protobuf", std::move(schema), source, {}, {}};
}

}  // namespace pongsim::web::foxglove
