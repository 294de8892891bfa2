#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "ros2/config/topic_rule.hh"

namespace pongsim::ros2 {

/// A word of the user's, and where he wrote it.
struct Said {
  std::string text;
  SourcePosition position;
};

/// What a user says of one topic or one service, in a file, an element or an option, before anybody has looked whether
/// there is such a thing.
struct RuleText {
  SourcePosition position;
  bool isService = false;
  /// Of the topic or the service.
  std::optional<Said> ros = std::nullopt;
  std::optional<Said> ignition = std::nullopt;
  std::optional<Said> rosType = std::nullopt;
  /// Of a topic.
  std::optional<Said> ignitionType = std::nullopt;
  /// Of a service.
  std::optional<Said> requestType = std::nullopt;
  std::optional<Said> replyType = std::nullopt;
  Direction direction = Direction::kBoth;
  WayRule toRos = {};
  WayRule fromRos = {};
  std::optional<Said> framePrefix = std::nullopt;
  std::optional<Said> frameId = std::nullopt;
};

}  // namespace pongsim::ros2
