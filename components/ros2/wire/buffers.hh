#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace pongsim::ros2 {

/// A payload on its way to the readers.
class Buffer {
 public:
  std::span<std::byte> bytes;

 private:
  friend class Buffers;
  std::unique_ptr<std::byte[]> room_;
  std::size_t capacity_ = 0;
};

/// A pool of buffers, so that a steady stream of messages allocates nothing. Any thread may use it.
class Buffers {
 public:
  /// @return A buffer of this size with unspecified content, to be given back.
  Buffer* take(std::size_t size);
  void giveBack(Buffer* buffer);

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<Buffer>> all_;
  /// Indexed by the power of two that is their capacity.
  std::array<std::vector<Buffer*>, 64> free_;
  std::size_t freeBytes_ = 0;
};

}  // namespace pongsim::ros2
