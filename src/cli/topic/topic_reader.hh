#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "cli/stop_signal.hh"
#include "pongsim/node.hh"

namespace pongsim::cli {

struct ReadOptions {
  std::string topic;
  /// Full name; empty: that of the topic's publisher.
  std::string type;
  /// Stop after this many messages.
  std::optional<std::uint64_t> count;
  /// Stop after this time.
  std::optional<std::chrono::nanoseconds> duration;
};

/// What to do with a topic's messages. The functions can end the reading by returning an exit code.
class TopicTask {
 public:
  virtual ~TopicTask() = default;
  /// Called once, when the messages' type is known.
  /// @param type Full name.
  virtual std::optional<int> begin([[maybe_unused]] const std::string& type) { return std::nullopt; }
  virtual std::optional<int> take(const Message& message) = 0;
  /// Called at least ten times a second.
  virtual std::optional<int> tick() { return std::nullopt; }
  /// Called when the reading ends without a failure: by count, by time or by a signal.
  /// @param isByTime Whether `ReadOptions::duration` has passed.
  /// @return The exit code.
  virtual int end(bool isByTime) = 0;
};

/// Reads a topic: waits for a publisher, tells the user if there is none or only one of another type, and passes the
/// messages to a task.
class TopicReader {
 public:
  explicit TopicReader(const ReadOptions& options);

  /// @return The exit code.
  int run(TopicTask& task);

  /// For other topics that a task reads.
  Transport& transport() { return transport_; }

 private:
  using Clock = std::chrono::steady_clock;

  bool isOver() const;
  bool isTimeOver() const { return end_ && Clock::now() >= *end_; }
  Clock::duration wait() const;
  void findType();
  void refuseWrongType();
  void sayWaiting();
  void read(TopicTask& task);
  void fail(const std::string& message, const std::string& hint = {});

  const ReadOptions options_;
  // before the transport, whose threads inherit the signal mask
  StopSignal signal_;
  Transport transport_;
  const Clock::time_point start_ = Clock::now();
  std::optional<Clock::time_point> end_;
  std::string type_;
  bool saidWaiting_ = false;
  std::uint64_t taken_ = 0;
  /// Set when the reading has ended.
  std::optional<int> exitCode_;
};

}  // namespace pongsim::cli
