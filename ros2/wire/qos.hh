#pragma once

#include <chrono>
#include <cstddef>
#include <optional>

namespace pongsim::ros2 {

/// Quality of service of a writer or a reader, as far as ROS 2 speaks of it. History is always "keep last".
struct Qos {
  /// Of a reader: whether it wants a reliable writer; a best-effort one takes what comes from either.
  bool isReliable = true;
  /// Whether late readers get the last `depth` messages (transient local); of a reader: whether it asks for them.
  bool isTransientLocal = false;
  /// So many messages are kept, at least 1.
  std::size_t depth = 10;
  /// What is older is not sent any more to who comes late. Unset: for ever.
  std::optional<std::chrono::seconds> lifespan = std::nullopt;
  bool operator==(const Qos&) const = default;
};

inline constexpr Qos kDefaultQos{};
inline constexpr Qos kSensorQos{.isReliable = false, .depth = 5};
inline constexpr Qos kLatchedQos{.isTransientLocal = true, .depth = 1};
/// Takes messages of every writer.
inline constexpr Qos kAnyWriterQos{.isReliable = false, .depth = 10};

}  // namespace pongsim::ros2
