#include "ros2/recording/offered_quality.hh"

namespace pongsim::ros2 {

namespace {

// Numbers of rmw/types.h.
constexpr int kKeepLast = 1;
constexpr int kReliable = 1, kBestEffort = 2;
constexpr int kTransientLocal = 1, kVolatile = 2;
constexpr int kAutomatic = 1;

/// @return A duration in two lines below its name; without a value it is infinite (RMW_DURATION_INFINITE).
std::string timeText(const std::optional<std::chrono::seconds>& time) {
  if (!time) return "\n    sec: 9223372036\n    nsec: 854775807\n";
  return "\n    sec: " + std::to_string(time->count()) + "\n    nsec: 0\n";
}

}  // namespace

std::string offeredQuality(const Qos& qos) {
  const auto line = [](const char* name, auto value) {
    return std::string("  ") + name + ": " + std::to_string(value) + "\n";
  };
  std::string text = line("history", kKeepLast) + line("depth", qos.depth) +
                     line("reliability", qos.isReliable ? kReliable : kBestEffort) +
                     line("durability", qos.isTransientLocal ? kTransientLocal : kVolatile) +
                     "  deadline:" + timeText(std::nullopt) + "  lifespan:" + timeText(qos.lifespan) +
                     line("liveliness", kAutomatic) + "  liveliness_lease_duration:" + timeText(std::nullopt) +
                     "  avoid_ros_namespace_conventions: false";
  text.front() = '-';
  return text;
}

}  // namespace pongsim::ros2
