#pragma once

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

/// A message on its way to one subscription.
struct Arrival {
  /// Counts from the transport's start, over all subscriptions.
  std::uint64_t number = 0;
  class Inbox* inbox = nullptr;
  Buffer* buffer = nullptr;
};

/// What waits for one subscription. For one thread at a time.
class Inbox {
 public:
  using Received = std::function<void(const Message&)>;
  using ReceivedBytes = std::function<void(std::span<const std::byte>)>;

  /// @param message What each arrival is read into.
  Inbox(Channel& channel, MessagePointer message, Received received, const SubscriptionOptions& options);
  Inbox(Channel& channel, ReceivedBytes received, const SubscriptionOptions& options);
  ~Inbox();

  /// @return The publisher that a subscription with such options does not hear, or null.
  static const void* excepted(const SubscriptionOptions& options);

  /// @return Whether the subscription wants a message that comes now, for it has not had as many as it may lately.
  bool wants();

  /// Puts the buffer behind the others. Where there is no room, the oldest go to `dropped`, and are counted.
  void add(std::uint64_t number, Buffer* buffer, std::vector<Buffer*>& dropped);

  /// Moves all that waits to the end of `arrivals`.
  void moveTo(std::vector<Arrival>& arrivals);

  std::size_t size() const { return waiting_.size() - first_; }
  /// What came, without the dropped ones.
  std::uint64_t received() const { return came_ - dropped_; }
  std::uint64_t dropped() const { return dropped_; }
  Channel& channel() const { return channel_; }

  /// Hands the message over, unless it can't be used.
  /// @return Why not ("is no ignition.msgs.Twist"), or nothing.
  std::optional<std::string> handOver(const Buffer& buffer) const { return take_(buffer.bytes); }

  /// Where it waits for `dispatch`.
  DispatchQueue* queue = nullptr;

  /// Whether its subscription has gone.
  bool ended = false;

  /// Hear what their own transport publishes at once, rather than from here: one of them, or none for others. Guarded
  /// by the channel's mutex for that.
  HeardAtOnce heardAtOnce;
  HeardBytesAtOnce heardBytesAtOnce;
  bool isAtOnce() const { return heardAtOnce || heardBytesAtOnce; }

  /// @return Whether it is to hear that publisher of its own transport.
  bool hears(const PublisherState& publisher) const;

  /// The publisher that it does not hear, or null.
  const void* except = nullptr;
  /// As the subscription's options say.
  bool relays = false;
  bool ownOnly = false;

  /// What its channel's reader had lost before there was this subscription.
  std::uint64_t lostBefore = 0;

 private:
  using Clock = std::chrono::steady_clock;

  Inbox(Channel& channel, const SubscriptionOptions& options);
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
