#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <utility>

namespace pongsim::ros2 {

/// Keeps bursts of large packets within the receive buffers of readers on this machine. A camera image is more than a
/// default buffer holds, and what does not fit is lost: for a best-effort reader the whole image. Any thread may use
/// it.
class BurstLimit {
 public:
  using Clock = std::chrono::steady_clock;

  /// Call before each packet. It waits until a large one fits into the reader's buffer; for a reader that does not
  /// read, 10 ms, and not again within 100 ms, so that it can't hold up the others for long.
  /// @param address An address of this machine, in network order.
  /// @return Whether there is room, as far as is known.
  bool awaitRoom(std::uint32_t address, std::uint16_t port, std::size_t size);

 private:
  struct Reader {
    /// Room that was seen, less what was sent since.
    std::size_t room = 0;
    /// Until then nobody waits for it.
    Clock::time_point givenUpUntil;
  };
  std::mutex mutex_;
  std::map<std::pair<std::uint32_t, std::uint16_t>, Reader> readers_;
};

}  // namespace pongsim::ros2
