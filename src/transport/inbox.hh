#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "pongsim/message.hh"
#include "transport/buffer_pool.hh"

namespace pongsim::transport {

class Channel;

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

  Inbox(Channel& channel, MessagePointer message, Received received, std::size_t limit);

  ~Inbox();

  /// @return The oldest arrival where there is no room for another; it is dropped and counted.
  Buffer* add(std::uint64_t number, Buffer* buffer);

  /// Moves all that waits to the end of `arrivals`.
  void moveTo(std::vector<Arrival>& arrivals);

  std::size_t size() const { return waiting_.size() - first_; }
  std::uint64_t dropped() const { return dropped_; }
  Channel& channel() const { return channel_; }

  /// Fills in the one message object that all arrivals share.
  /// @return Whether the bytes are a message of its type.
  bool parse(const Buffer& buffer);
  void handOver() const { received_(*message_); }

  /// Whether its subscription has gone.
  bool ended = false;

 private:
  Channel& channel_;
  MessagePointer message_;
  Received received_;
  std::size_t limit_;
  std::vector<Arrival> waiting_;
  std::size_t first_ = 0;
  std::uint64_t dropped_ = 0;
};

}  // namespace pongsim::transport
