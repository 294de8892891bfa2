#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "pongsim/element.hh"
#include "ros2/pairs/pair.hh"

namespace pongsim::ros2 {

enum class Direction { kBoth, kToRos, kFromRos };

/// One topic that is bridged because somebody said so.
struct TopicRule {
  /// "/scan", in full.
  std::string ros;
  /// The simulation's: "/lidar".
  std::string ignition;
  const Pair* pair = nullptr;
  Direction direction = Direction::kBoth;
  /// Whether the simulation's topic is listened to only where a node of ROS listens in turn. One that is not is
  /// listened to from the start, so that what comes late gets the last messages of the writer.
  bool isLazy = true;
  /// Depths of the writer and of the reader of ROS.
  std::size_t publisherQueue = 10;
  std::size_t subscriberQueue = 10;
  /// Unset: as usual for what it is.
  std::optional<bool> isReliable = std::nullopt;
  std::optional<bool> isTransientLocal = std::nullopt;
  /// Where the rule was said, for messages.
  SourcePosition position = {};
};

}  // namespace pongsim::ros2
