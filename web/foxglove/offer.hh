#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "web/server/session.hh"

namespace pongsim::web::foxglove {

/// Makes what stands in front of a message of that simulated time [ns].
using Head = std::function<std::string(std::uint64_t timeNs)>;

/// A channel that clients may subscribe.
struct Offer {
  std::string topic;
  /// Of its messages: "protobuf".
  std::string encoding;
  /// Full name of the message type.
  std::string schemaName;
  /// Of the schema: "protobuf"; empty: as of the messages.
  std::string schemaEncoding;
  /// As text; what is binary as base64.
  std::shared_ptr<const std::string> schema;
  /// Which one it is, apart from others of the same name: a channel with another source is another channel.
  const void* source = nullptr;
  /// Sends the client's messages under that key, until what is returned is destroyed.
  std::function<std::shared_ptr<void>(const std::shared_ptr<Client>& client, std::uint64_t key, Head head)> open;

  bool isAs(const Offer& other) const {
    return topic == other.topic && encoding == other.encoding && schemaName == other.schemaName &&
           source == other.source;
  }
};

}  // namespace pongsim::web::foxglove
