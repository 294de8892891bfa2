#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace pongsim::transport {

/// A process's place in the DDS domain: the prefix of its GUIDs. All zeros for this one's own.
using ParticipantId = std::array<std::uint8_t, 12>;

/// A message's bytes, for all who wait for it.
class Buffer {
 public:
  /// All of its room, or the part of it that is meant.
  std::span<std::byte> bytes;
  ParticipantId sender{};
  std::size_t users = 0;

  /// Makes `bytes` so long, of no particular content.
  void resize(std::size_t size);
  std::size_t capacity() const { return capacity_; }

  /// Exchanges the bytes for another's, and nothing else.
  void swapBytes(Buffer& other) {
    std::swap(bytes, other.bytes);
    std::swap(room_, other.room_);
    std::swap(capacity_, other.capacity_);
  }

 private:
  std::unique_ptr<std::byte[]> room_;
  std::size_t capacity_ = 0;
};

/// Buffers that were used before, so that a steady flow of messages allocates nothing. For one thread at a time.
class BufferPool {
 public:
  /// @return A buffer of so many bytes, of no particular content, for one user. One that was used before has room for
  /// twice as many at most, so that small messages do not sit in the room of large ones.
  Buffer* take(std::size_t size);

  /// Ends one use.
  void giveBack(Buffer* buffer);

 private:
  std::vector<std::unique_ptr<Buffer>> all_;
  /// By the power of two that is their capacity.
  std::array<std::vector<Buffer*>, 64> free_;
  std::size_t freeBytes_ = 0;
};

}  // namespace pongsim::transport
