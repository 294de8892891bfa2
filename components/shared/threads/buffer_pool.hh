#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace pongsim::shared {

/// Frees a buffer's memory.
struct FreeBytes {
  std::size_t capacity = 0;
  void operator()(std::byte* bytes) const;
};

/// A message's bytes, shared by all subscriptions that wait for it.
class Buffer {
 public:
  /// The used part of its memory.
  std::span<std::byte> bytes;
  /// The participant that sent it; all zeros: this process.
  std::array<std::uint8_t, 12> sender{};
  std::size_t users = 0;

  /// Sets the size of `bytes`, with undefined content.
  void resize(std::size_t size);
  std::size_t capacity() const { return room_.get_deleter().capacity; }

  /// Swaps only the bytes with another buffer.
  void swapBytes(Buffer& other) {
    std::swap(bytes, other.bytes);
    std::swap(room_, other.room_);
  }

 private:
  friend class BufferPool;

  std::unique_ptr<std::byte[], FreeBytes> room_;
  /// Its index in the pool.
  std::size_t index_ = 0;
};

/// Reuses buffers, so that a steady flow of messages does not allocate. Not thread-safe.
///
/// What a burst of messages needed is freed later: of the buffers that were never in use during a period, half are.
class BufferPool {
 public:
  /// How many buffers are given back in a period.
  static constexpr std::size_t kPeriod = 20'000;

  /// @return A buffer of that size for one user, with undefined content. Its capacity is at most twice the size, so
  /// that small messages do not occupy large buffers.
  Buffer* take(std::size_t size);

  /// Ends one use.
  void giveBack(Buffer* buffer);

  /// @return The total capacity of the buffers that nobody uses [bytes].
  std::size_t spareBytes() const { return spareBytes_; }

 private:
  struct Spare {
    std::vector<Buffer*> buffers;
    /// The least number of them in this period, and how many of them are to be freed.
    std::size_t least = 0, surplus = 0;
  };

  Buffer* takeFrom(Spare& spare);
  void beginPeriod();
  void freeOne();
  void free(Buffer* buffer);

  std::vector<std::unique_ptr<Buffer>> all_;
  /// By capacity, which is a power of two.
  std::array<Spare, 64> spare_;
  std::size_t spareBytes_ = 0, surplus_ = 0, givenBack_ = 0;
};

}  // namespace pongsim::shared
