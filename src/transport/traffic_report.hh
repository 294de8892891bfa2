#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace pongsim::transport {

enum class Role { kPublisher, kSubscriber };

/// What has passed through all publishers, or all subscriptions, that a participant has of a topic.
struct EndpointTraffic {
  std::string topic;
  std::string type;
  Role role = Role::kPublisher;
  /// Sent or received since the first of them is there.
  std::uint64_t messages = 0;
  std::uint64_t dropped = 0;
  bool operator==(const EndpointTraffic&) const = default;
};

/// What a participant tells of its traffic when it is asked.
struct TrafficReport {
  /// By a clock of its own, which goes at the same pace as all others.
  std::chrono::nanoseconds at{0};
  std::vector<EndpointTraffic> endpoints;
  bool operator==(const TrafficReport&) const = default;
};

/// @return The report as bytes. Names are told up to 65,535 letters.
std::vector<std::byte> trafficBytes(const TrafficReport& report);

/// @return What any bytes say, or nothing where they are no report.
std::optional<TrafficReport> readTraffic(std::span<const std::byte> bytes);

}  // namespace pongsim::transport
