#include "ros2/wire/burst_limit.hh"

#include <algorithm>
#include <optional>
#include <thread>

#include "ros2/wire/receive_buffer.hh"

namespace pongsim::ros2 {

namespace {

/// Smaller packets are no images.
constexpr std::size_t kLargePacket = 16 * 1024;
/// What the kernel counts for a packet beside its bytes, at most: its headers, and the rest of its last page.
constexpr std::size_t kAdministration = 4096;
constexpr std::chrono::milliseconds kLongestWait{10};
constexpr std::chrono::milliseconds kGivenUp{100};
constexpr std::chrono::microseconds kBetweenLooks{50};
/// Readers that are known to have been sent to; they come and go.
constexpr std::size_t kMostReaders = 4096;

}  // namespace

bool BurstLimit::awaitRoom(std::uint32_t address, std::uint16_t port, std::size_t size) {
  if (size < kLargePacket) return true;
  const std::size_t needed = size + kAdministration;
  const std::pair key{address, port};
  {
    const std::lock_guard lock(mutex_);
    if (readers_.size() > kMostReaders) readers_.clear();
    Reader& reader = readers_[key];
    if (Clock::now() < reader.givenUpUntil) return false;
    if (reader.room >= needed) {
      reader.room -= needed;
      return true;
    }
  }
  const Clock::time_point end = Clock::now() + kLongestWait;
  while (true) {
    const std::optional<ReceiveBuffer> buffer = receiveBufferOf(address, port);
    if (!buffer) return true;
    const std::size_t room = buffer->size - std::min(buffer->size, buffer->used);
    // the kernel takes any packet into an empty buffer
    if (room >= needed || buffer->used == 0) {
      const std::lock_guard lock(mutex_);
      readers_[key].room = room - std::min(room, needed);
      return true;
    }
    if (Clock::now() >= end) break;
    std::this_thread::sleep_for(kBetweenLooks);
  }
  const std::lock_guard lock(mutex_);
  readers_[key] = {0, Clock::now() + kGivenUp};
  return false;
}

}  // namespace pongsim::ros2
