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

/// The thread that speaks to ign-transport, whose locks others hold for 100 ms and more: the simulation never waits for
/// it. What is beyond 10,000 messages or 64 MiB is dropped, the oldest first, with a warning.
class Courier {
 public:
  /// @param heardChanged Called on the courier's thread when a topic has got its first reader or lost its last one.
  /// @param address At which this process speaks.
  Courier(const Logger& log, const std::string& address, std::function<void()> heardChanged);
  /// Does what it was asked to do, and ends.
  ~Courier();
  Courier(const Courier&) = delete;
  Courier& operator=(const Courier&) = delete;

  /// Has it done on the thread, in order. Returns at once.
  void post(std::function<void()> task);

  /// Advertises the topic, and looks from then on for who listens.
  void open(std::shared_ptr<OutgoingTopic> topic);
  /// Ends it there, too, for that may wait for the library.
  void close(std::shared_ptr<OutgoingTopic> topic);

  /// Has a message sent. Returns at once.
  void send(const std::shared_ptr<OutgoingTopic>& topic, Payload payload);

  /// @return Messages that were dropped so far, beside those that ZeroMQ drops for readers that are behind.
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
  /// For the thread.
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
  // begins last
  std::thread thread_;
};

}  // namespace pongsim::ign
