#include "ros2/wire/burst_limit.hh"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <thread>

namespace pongsim::ros2 {

namespace {

/// Smaller packets are no images.
constexpr std::size_t kLargePacket = 16 * 1024;
/// Linux's default buffer, net.core.rmem_default, has 208 KiB, in which it counts packets with their administration.
constexpr std::size_t kLargestBurst = 128 * 1024;
constexpr std::size_t kAlmostEmpty = 16 * 1024;
constexpr std::chrono::milliseconds kLongestWait{10};
constexpr std::chrono::milliseconds kGivenUp{100};
constexpr std::chrono::microseconds kBetweenLooks{100};
/// Ports that are known to have been sent to; readers come and go.
constexpr std::size_t kMostPorts = 4096;

}  // namespace

std::optional<std::size_t> bytesQueuedAt(std::uint16_t port) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> table(std::fopen("/proc/net/udp", "re"), &std::fclose);
  if (!table) return std::nullopt;
  std::optional<std::size_t> most;
  char line[256];
  while (std::fgets(line, sizeof line, table.get()) != nullptr) {
    unsigned int local = 0;
    unsigned long queued = 0;
    // number: address:port address:port state sent:queued
    if (std::sscanf(line, " %*d: %*x:%x %*x:%*x %*x %*x:%lx", &local, &queued) != 2 || local != port) continue;
    most = std::max<std::size_t>(most.value_or(0), queued);
  }
  return most;
}

bool BurstLimit::awaitRoom(std::uint16_t port, std::size_t size) {
  if (size < kLargePacket) return true;
  {
    const std::lock_guard lock(mutex_);
    if (bursts_.size() > kMostPorts) bursts_.clear();
    Burst& burst = bursts_[port];
    burst.sent += size;
    if (Clock::now() < burst.givenUpUntil) return false;
    if (burst.sent <= kLargestBurst) return true;
    burst.sent = size;
  }
  const Clock::time_point end = Clock::now() + kLongestWait;
  while (true) {
    const std::optional<std::size_t> queued = bytesQueuedAt(port);
    if (!queued || *queued < kAlmostEmpty) return true;
    if (Clock::now() >= end) break;
    std::this_thread::sleep_for(kBetweenLooks);
  }
  const std::lock_guard lock(mutex_);
  bursts_[port].givenUpUntil = Clock::now() + kGivenUp;
  return false;
}

}  // namespace pongsim::ros2
