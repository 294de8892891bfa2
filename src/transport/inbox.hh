#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "pongsim/message.hh"

namespace pongsim::transport {

class Channel;

/// A process's place in the DDS domain: the prefix of its GUIDs. All zeros for this one's own.
using ParticipantId = std::array<std::uint8_t, 12>;

/// A message's bytes, for all who wait for it.
struct Buffer {
  std::vector<std::byte> bytes;
  ParticipantId sender{};
  std::size_t users = 0;
};

/// Buffers that were used before, so that a steady flow of messages allocates nothing. For one thread at a time.
class BufferPool {
 public:
  /// @return A buffer of no particular content for one user.
  Buffer* take();

  /// Ends one use.
  void giveBack(Buffer* buffer);

 private:
  std::vector<std::unique_ptr<Buffer>> all_;
  std::vector<Buffer*> free_;
  std::size_t freeBytes_ = 0;
};

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
