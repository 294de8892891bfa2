#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "pongsim/element.hh"
#include "ros2/pairs/pair.hh"

namespace pongsim::ros2 {

enum class Direction { kBoth, kToRos, kFromRos };

/// What somebody wishes of one way of a topic. Unset: as usual for what it is.
struct WayRule {
  /// To ROS: so many messages the writer keeps for its readers, 1 or more. What comes from ROS is handed on at once, so
  /// that there it means nothing.
  std::optional<std::size_t> depth = std::nullopt;
  /// To ROS: whether the simulation's topic is listened to only while a node of ROS listens in turn; one that is not
  /// lazy is listened to from the start. From ROS: whether the topic of ROS is read only while somebody in the
  /// simulation, or another process, listens.
  std::optional<bool> isLazy = std::nullopt;
  std::optional<bool> isReliable = std::nullopt;
  std::optional<bool> isTransientLocal = std::nullopt;
  bool operator==(const WayRule&) const = default;
};

/// One topic that is bridged because somebody said so.
struct TopicRule {
  /// "/scan", in full.
  std::string ros;
  /// The simulation's: "/lidar".
  std::string ignition;
  const Pair* pair = nullptr;
  Direction direction = Direction::kBoth;
  WayRule toRos;
  WayRule fromRos;
  /// What the names of frames become; unset: as those of the whole bridge.
  std::optional<std::string> framePrefix = std::nullopt;
  /// The frame of all messages to ROS, as it is, where it is not empty.
  std::string frameId;
  /// Where the rule was said, for messages; without a file where nobody said it.
  SourcePosition position = {};

  bool goesToRos() const { return direction != Direction::kFromRos; }
  bool comesFromRos() const { return direction != Direction::kToRos; }
};

}  // namespace pongsim::ros2
