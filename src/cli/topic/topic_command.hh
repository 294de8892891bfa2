#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/topic/field_condition.hh"
#include "cli/topic/topic_reader.hh"
#include "pongsim/message.hh"

namespace pongsim::cli {

/// How long to wait for somebody to come, where the user does not say.
inline constexpr std::chrono::milliseconds kArrivalTime{1000};

enum class EchoFormat { kText, kJson, kCsv };

struct EchoOptions {
  ReadOptions read;
  EchoFormat format = EchoFormat::kText;
  /// Paths of the values to print; empty: all of the message.
  std::vector<std::string> fields;
};

struct PublishOptions {
  std::string topic;
  /// Full name.
  std::string type;
  std::shared_ptr<const Message> message;
  /// How long to wait for a subscriber, and then for it to have the messages.
  std::chrono::nanoseconds timeout = std::chrono::seconds(1);
  /// From one message to the next; unset: there is only one.
  std::optional<std::chrono::nanoseconds> period;
  /// Unset, with a period: until a signal.
  std::optional<std::uint64_t> count;
};

/// What `topic --hz` and `topic --bw` print once a second.
enum class RateKind { kMessages, kBytes };

/// What `pongsim topic` does; each returns the exit code.
/// @param isVerbose With types and counts, and those that are only subscribed to.
int listTopics(bool isVerbose, bool asJson);
int showTopic(const std::string& topic, bool asJson);
int echoTopic(const EchoOptions& options);
/// Draws the scans of a lidar.
int plotTopic(const ReadOptions& options);
int publish(const PublishOptions& options);
int measureTopic(const ReadOptions& options, RateKind kind, bool asJson);
/// How late messages come, by the clock of the run that stamps them.
int measureDelay(const ReadOptions& options, bool asJson);
/// @param condition Unset: any message will do.
int waitForMessage(const ReadOptions& options, const std::optional<FieldCondition>& condition);

}  // namespace pongsim::cli
