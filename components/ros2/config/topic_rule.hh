#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "pongsim/element.hh"
#include "ros2/pairs/pair.hh"

namespace pongsim::ros2 {

enum class Direction { kBoth, kToRos, kFromRos };

/// Options for one direction of a topic. Unset: the default for its type.
struct DirectionRule {
  /// To ROS: how many messages the writer keeps for its readers, at least 1. Has no effect from ROS, because messages
  /// are passed on immediately.
  std::optional<std::size_t> depth = std::nullopt;
  /// To ROS: whether the simulation's topic is subscribed to only while a ROS node subscribes; if not lazy, it is
  /// subscribed to from the start. From ROS: whether the ROS topic is read only while somebody in the simulation, or
  /// another process, subscribes.
  std::optional<bool> isLazy = std::nullopt;
  std::optional<bool> isReliable = std::nullopt;
  std::optional<bool> isTransientLocal = std::nullopt;
  bool operator==(const DirectionRule&) const = default;
};

/// A topic that is bridged by a rule.
struct TopicRule {
  /// Absolute name, "/scan".
  std::string ros;
  /// Name in the simulation: "/lidar".
  std::string ignition;
  const Pair* pair = nullptr;
  Direction direction = Direction::kBoth;
  DirectionRule toRos;
  DirectionRule fromRos;
  /// Prefix for frame names; unset: that of the whole bridge.
  std::optional<std::string> framePrefix = std::nullopt;
  /// If not empty, the frame of all messages to ROS, used unchanged.
  std::string frameId;
  /// Where the rule was given, for messages; has no file if there is no such place.
  SourcePosition position = {};

  bool goesToRos() const { return direction != Direction::kFromRos; }
  bool comesFromRos() const { return direction != Direction::kToRos; }
};

}  // namespace pongsim::ros2
