#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "ros2/config/topic_rule.hh"

namespace pongsim::ros2 {

/// A word from the user, and its position.
struct GivenText {
  std::string text;
  SourcePosition position;
};

/// What a user writes about one topic or service, in a file, an element or an option, before it is validated.
struct RuleText {
  SourcePosition position;
  bool isService = false;
  /// For topics and services.
  std::optional<GivenText> ros = std::nullopt;
  std::optional<GivenText> ignition = std::nullopt;
  std::optional<GivenText> rosType = std::nullopt;
  /// For topics.
  std::optional<GivenText> ignitionType = std::nullopt;
  /// For services.
  std::optional<GivenText> requestType = std::nullopt;
  std::optional<GivenText> replyType = std::nullopt;
  Direction direction = Direction::kBoth;
  DirectionRule toRos = {};
  DirectionRule fromRos = {};
  std::optional<GivenText> framePrefix = std::nullopt;
  std::optional<GivenText> frameId = std::nullopt;
};

}  // namespace pongsim::ros2
