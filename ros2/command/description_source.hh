#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "ros2/node/node.hh"

namespace pongsim::ros2 {

/// How the search for a robot's description goes.
struct SearchOptions {
  /// Unset: it goes on until there is one.
  std::optional<std::chrono::nanoseconds> timeout;
  /// Told what is waited for, when it takes longer than a second, and again where there is more to say.
  std::function<void(std::string_view)> say;
};

/// Reads a description that some node keeps for who comes late, as /robot_description of robot_state_publisher.
/// @param topic Of type std_msgs/msg/String.
/// @return Nothing where there was none in time.
/// @throws std::invalid_argument for a name that is none.
std::optional<std::string> descriptionFromTopic(RosNode& node, const std::string& topic, const SearchOptions& options);

/// Reads a description from a parameter of a running node, a text.
/// @param owner The node that has it; empty: the first one that does.
/// @return Nothing where there was none in time.
/// @throws std::invalid_argument for a name that is none.
std::optional<std::string> descriptionFromParameter(RosNode& node, const std::string& owner,
                                                    const std::string& parameter, const SearchOptions& options);

}  // namespace pongsim::ros2
