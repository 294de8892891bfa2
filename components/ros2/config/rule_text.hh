#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "ros2/config/topic_rule.hh"

namespace pongsim::ros2 {

/// A word from the user, and its position.
struct Said {
  std::string text;
  SourcePosition position;
};

/// What a user writes about one topic or service, in a file, an element or an option, before it is validated.
struct RuleText {
  SourcePosition position;
  bool isService = false;
  /// For topics and services.
  std::optional<Said> ros = std::nullopt;
  std::optional<Said> ignition = std::nullopt;
  std::optional<Said> rosType = std::nullopt;
  /// For topics.
  std::optional<Said> ignitionType = std::nullopt;
  /// For services.
  std::optional<Said> requestType = std::nullopt;
  std::optional<Said> replyType = std::nullopt;
  Direction direction = Direction::kBoth;
  WayRule toRos = {};
  WayRule fromRos = {};
  std::optional<Said> framePrefix = std::nullopt;
  std::optional<Said> frameId = std::nullopt;
};

}  // namespace pongsim::ros2
