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
inline constexpr ParticipantId kThisProcess{};

/// A message's bytes, shared by all subscriptions that wait for it.
class Buffer {
 public:
  /// The used part of its memory.
  std::span<std::byte> bytes;
  ParticipantId sender{};
  std::size_t users = 0;

  /// Sets the size of `bytes`, with undefined content.
  void resize(std::size_t size);
  std::size_t capacity() const { return capacity_; }

  /// Swaps only the bytes with another buffer.
  void swapBytes(Buffer& other) {
    std::swap(bytes, other.bytes);
    std::swap(room_, other.room_);
    std::swap(capacity_, other.capacity_);
  }

 private:
  std::unique_ptr<std::byte[]> room_;
  std::size_t capacity_ = 0;
};

/// Reuses buffers, so that a steady flow of messages does not allocate. Not thread-safe.
class BufferPool {
 public:
  /// @return A buffer of that size for one user, with undefined content. Its capacity is at most twice the size, so
  /// that small messages do not occupy large buffers.
  Buffer* take(std::size_t size);

  /// Ends one use.
  void giveBack(Buffer* buffer);

 private:
  std::vector<std::unique_ptr<Buffer>> all_;
  /// By capacity, which is a power of two.
  std::array<std::vector<Buffer*>, 64> free_;
  std::size_t freeBytes_ = 0;
};

}  // namespace pongsim::transport
