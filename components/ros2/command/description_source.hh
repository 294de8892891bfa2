#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "ros2/node/node.hh"

namespace pongsim::ros2 {

/// How to search for a robot's description.
struct SearchOptions {
  /// Unset: search until there is one.
  std::optional<std::chrono::nanoseconds> timeout;
  /// Called with what is being waited for, if it takes longer than a second, and again when there is news.
  std::function<void(std::string_view)> say;
};

/// Reads a description that a node keeps for late subscribers, like /robot_description of robot_state_publisher.
/// @param topic Of type std_msgs/msg/String.
/// @return Nothing if there was none in time.
/// @throws std::invalid_argument for an invalid name.
std::optional<std::string> descriptionFromTopic(RosNode& node, const std::string& topic, const SearchOptions& options);

/// Reads a description from a string parameter of a running node.
/// @param owner The node that has it; empty: the first one that does.
/// @return Nothing if there was none in time.
/// @throws std::invalid_argument for an invalid name.
std::optional<std::string> descriptionFromParameter(RosNode& node, const std::string& owner,
                                                    const std::string& parameter, const SearchOptions& options);

}  // namespace pongsim::ros2
