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

/// Traffic of all publishers, or all subscriptions, of a participant on a topic.
struct EndpointTraffic {
  std::string topic;
  std::string type;
  Role role = Role::kPublisher;
  /// Sent or received since the first of them exists.
  std::uint64_t messages = 0;
  std::uint64_t dropped = 0;
  bool operator==(const EndpointTraffic&) const = default;
};

/// A participant's report of its traffic.
struct TrafficReport {
  /// Time by the participant's own clock.
  std::chrono::nanoseconds at{0};
  std::vector<EndpointTraffic> endpoints;
  bool operator==(const TrafficReport&) const = default;
};

/// @return The report as bytes. Names are cut at 65,535 characters.
std::vector<std::byte> trafficBytes(const TrafficReport& report);

/// @return The report, or nothing if the bytes are not one.
std::optional<TrafficReport> readTraffic(std::span<const std::byte> bytes);

}  // namespace pongsim::transport
