#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace pongsim::transport {

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

}  // namespace pongsim::transport
