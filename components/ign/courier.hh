#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "ign/heartbeats.hh"
#include "ign/outgoing_topic.hh"
#include "ign/payload.hh"
#include "pongsim/log.hh"

namespace pongsim::ign {

/// The thread that calls ign-transport: other threads hold the library's locks for 100 ms and more, and the simulation
/// must not wait for them. If more than 10,000 messages or 64 MiB are queued, the oldest are dropped, with a warning.
class Courier {
 public:
  /// @param heardChanged Called on the courier's thread when a topic has got its first subscriber or lost its last one.
  /// @param address IPv4 address at which this process uses ign-transport.
  /// @param subscribersAsked Called on the courier's thread, at most ten times a second, when another process wants the
  /// list of this one's subscriptions.
  Courier(
      const Logger& log, const std::string& address, std::function<void()> heardChanged,
      std::function<void()> subscribersAsked = [] {});
  /// Finishes all queued messages and tasks.
  ~Courier();
  Courier(const Courier&) = delete;
  Courier& operator=(const Courier&) = delete;

  /// Queues a task for the courier's thread. Returns immediately.
  void post(std::function<void()> task);

  /// Advertises the topic on the courier's thread, and from then on checks for its subscribers.
  void open(std::shared_ptr<OutgoingTopic> topic);
  /// Unadvertises the topic, and releases it on the courier's thread, because its destructor may wait for the library.
  void close(std::shared_ptr<OutgoingTopic> topic);

  /// Queues a message. Returns immediately.
  void send(const std::shared_ptr<OutgoingTopic>& topic, Payload payload);

  /// @return The number of messages dropped so far, without those that ZeroMQ drops for slow subscribers.
  std::uint64_t dropped() const { return dropped_; }

 private:
  struct Parcel {
    std::shared_ptr<OutgoingTopic> topic;
    Payload payload;
  };

  void work();
  void deliver(std::deque<Parcel>& parcels);
  void drop(const Parcel& parcel);
  void look();

  const Logger& log_;
  std::function<void()> heardChanged_;
  std::function<void()> subscribersAsked_;
  std::chrono::steady_clock::time_point nextAnswer_;
  /// Only used on the courier's thread.
  std::vector<std::shared_ptr<OutgoingTopic>> topics_;
  Heartbeats heartbeats_;

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> tasks_;
  std::deque<Parcel> parcels_;
  std::size_t waitingBytes_ = 0;
  bool isWaiting_ = false;
  bool mustEnd_ = false;
  std::atomic<std::uint64_t> dropped_ = 0;
  std::int64_t nextWarning_ = 0;
  // declared last: the thread uses the members above
  std::thread thread_;
};

}  // namespace pongsim::ign
