#pragma once

#include <atomic>
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

/// The thread that calls ign-transport, whose locks others hold for 100 ms and more: the simulation never waits for it.
/// If more than 10,000 messages or 64 MiB are queued, the oldest are dropped, with a warning.
class Courier {
 public:
  /// @param heardChanged Called on the courier's thread when a topic has got its first subscriber or lost its last one.
  /// @param address The address at which this process uses ign-transport.
  Courier(const Logger& log, const std::string& address, std::function<void()> heardChanged);
  /// Finishes the queued work first.
  ~Courier();
  Courier(const Courier&) = delete;
  Courier& operator=(const Courier&) = delete;

  /// Queues a task for the thread. Returns immediately.
  void post(std::function<void()> task);

  /// Advertises the topic, and from then on checks for subscribers.
  void open(std::shared_ptr<OutgoingTopic> topic);
  /// Also closes it on the courier's thread, because that may wait for the library.
  void close(std::shared_ptr<OutgoingTopic> topic);

  /// Queues a message. Returns immediately.
  void send(const std::shared_ptr<OutgoingTopic>& topic, Payload payload);

  /// @return Number of messages dropped so far, not counting those that ZeroMQ drops for slow subscribers.
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
  // starts last
  std::thread thread_;
};

}  // namespace pongsim::ign
