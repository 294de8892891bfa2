#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "pongsim/message.hh"

namespace pongsim::cli {

/// How long a look around waits for the other processes to tell of their topics.
inline constexpr std::chrono::milliseconds kDiscoveryTime{1000};

struct EchoOptions {
  std::string topic;
  /// Full name; empty: what the topic's publisher has.
  std::string type;
  /// End after that many messages.
  std::optional<std::uint64_t> count;
  /// End after that time.
  std::optional<std::chrono::nanoseconds> duration;
  bool json = false;
};

struct PublishOptions {
  std::string topic;
  /// Full name.
  std::string type;
  std::shared_ptr<const Message> message;
  /// How long to wait for a subscriber, and then for it to have the message.
  std::chrono::nanoseconds timeout = std::chrono::seconds(1);
};

/// What `pongsim topic` does; each returns the exit code.
int listTopics();
int showTopic(const std::string& topic);
int echoTopic(const EchoOptions& options);
int publishOnce(const PublishOptions& options);

}  // namespace pongsim::cli
