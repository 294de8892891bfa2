#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pongsim/message.hh"
#include "pongsim/node.hh"
#include "transport/buffer_pool.hh"

namespace pongsim::transport {

class Channel;
class DispatchQueue;
class PublisherState;

/// A message for one subscription.
struct Arrival {
  /// Counted since the transport's start, over all subscriptions.
  std::uint64_t number = 0;
  class Inbox* inbox = nullptr;
  Buffer* buffer = nullptr;
};

/// Waiting messages of one subscription. Not thread-safe.
class Inbox {
 public:
  using Received = std::function<void(const Message&)>;
  using ReceivedBytes = std::function<void(std::span<const std::byte>)>;

  /// @param message Messages are parsed into it.
  Inbox(Channel& channel, MessagePointer message, Received received, const SubscriptionOptions& options);
  Inbox(Channel& channel, ReceivedBytes received, const SubscriptionOptions& options);
  ~Inbox();

  /// @return The publisher that a subscription with these options ignores, or null.
  static const void* excepted(const SubscriptionOptions& options);

  /// @return Whether a message that arrives now is accepted, given the subscription's maximum rate.
  bool wants();

  /// Appends a buffer. If there is no room, the oldest ones are moved to `dropped` and counted.
  void add(std::uint64_t number, Buffer* buffer, std::vector<Buffer*>& dropped);

  /// Moves all waiting messages to the end of `arrivals`.
  void moveTo(std::vector<Arrival>& arrivals);
  /// Forgets all waiting messages. Takes no memory.
  void forgetUnread(const std::function<void(Buffer*)>& giveBack);

  std::size_t size() const { return waiting_.size() - first_; }
  /// Without dropped ones.
  std::uint64_t received() const { return came_ - dropped_; }
  std::uint64_t dropped() const { return dropped_; }
  Channel& channel() const { return channel_; }

  /// Passes the message to the subscription.
  /// @return Why it can't be used ("is not of type ignition.msgs.Twist"), or nothing.
  std::optional<std::string> handOver(const Buffer& buffer) const { return take_(buffer.bytes); }

  /// Where it waits for `dispatch`.
  DispatchQueue* queue = nullptr;

  /// Whether its subscription has ended.
  std::atomic<bool> ended = false;

  /// Receive messages of their own transport within `publish`; at most one is set. Guarded by the channel's `hearing`.
  HeardAtOnce heardAtOnce;
  HeardBytesAtOnce heardBytesAtOnce;
  bool isAtOnce() const { return heardAtOnce || heardBytesAtOnce; }

  /// @return Whether it receives from that publisher of its own transport.
  bool hears(const PublisherState& publisher) const;

  /// The publisher that it ignores, or null.
  const void* except = nullptr;
  /// As in the subscription's options.
  bool relays = false;
  bool ownOnly = false;

  /// Losses of the channel's reader before this subscription.
  std::uint64_t lostBefore = 0;

 private:
  using Clock = std::chrono::steady_clock;

  Inbox(Channel& channel, const SubscriptionOptions& options);
  void clear();
  Buffer* removeOldest();

  Channel& channel_;
  std::function<std::optional<std::string>(std::span<const std::byte>)> take_;
  std::size_t limit_;
  std::optional<Clock::duration> period_;
  Clock::time_point next_;
  std::vector<Arrival> waiting_;
  std::size_t first_ = 0;
  std::size_t waitingBytes_ = 0;
  std::uint64_t came_ = 0;
  std::uint64_t dropped_ = 0;
};

}  // namespace pongsim::transport
