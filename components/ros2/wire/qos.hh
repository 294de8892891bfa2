#pragma once

#include <chrono>
#include <cstddef>
#include <optional>

namespace pongsim::ros2 {

/// Quality of service of a writer or a reader, as far as ROS 2 uses it. History is always "keep last".
struct Qos {
  /// For readers: whether the writer must be reliable; a best-effort reader accepts either.
  bool isReliable = true;
  /// Whether late readers get the last `depth` messages (transient local); for readers: whether it requests them.
  bool isTransientLocal = false;
  /// Number of messages kept, at least 1.
  std::size_t depth = 10;
  /// Older messages are no longer sent to late readers. Unset: no limit.
  std::optional<std::chrono::seconds> lifespan = std::nullopt;
  bool operator==(const Qos&) const = default;
};

inline constexpr Qos kDefaultQos{};
inline constexpr Qos kSensorQos{.isReliable = false, .depth = 5};
inline constexpr Qos kLatchedQos{.isTransientLocal = true, .depth = 1};
/// Accepts messages of every writer.
inline constexpr Qos kAnyWriterQos{.isReliable = false, .depth = 10};

}  // namespace pongsim::ros2
