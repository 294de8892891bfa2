#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>

namespace pongsim::ros2 {

/// @return How many bytes wait in the receive buffer of this machine's UDP sockets at a port, as the kernel counts
/// them: that of the fullest; nothing if the kernel does not tell.
std::optional<std::size_t> bytesQueuedAt(std::uint16_t port);

/// Keeps bursts of large packets within the receive buffers of readers on this machine. A camera image is more than a
/// default buffer holds, and what does not fit is lost: for a best-effort reader the whole image. Any thread may use
/// it.
class BurstLimit {
 public:
  using Clock = std::chrono::steady_clock;

  /// Call before each packet. After some large ones it waits until the port's socket has been read; for a reader that
  /// does not read, 10 ms, and not again within 100 ms, so that it can't hold up the others for long.
  /// @return Whether there is room, as far as is known.
  bool awaitRoom(std::uint16_t port, std::size_t size);

 private:
  struct Burst {
    std::size_t sent = 0;
    /// Until then nobody waits for it.
    Clock::time_point givenUpUntil;
  };
  std::mutex mutex_;
  std::map<std::uint16_t, Burst> bursts_;
};

}  // namespace pongsim::ros2
