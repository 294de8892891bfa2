#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace pongsim::ros2 {

/// Topic on which participants announce their nodes, and which endpoints belong to each.
inline constexpr const char* kDiscoveryTopic = "ros_discovery_info";

/// @return What is wrong with an absolute ROS name ("has a '-'"), or nothing.
std::optional<std::string> rosNameError(std::string_view name);

/// @return `name` if it is absolute, else the name inside the namespace ("/" or "/robot").
std::string absoluteName(std::string_view nameSpace, std::string_view name);

/// @return A ROS name for a topic of the simulation: characters that ROS does not allow become '_', and a word that
/// starts with a digit gets a '_' in front.
std::string rosNameFor(std::string_view topic);

// Names on the wire.
std::string topicOnWire(std::string_view name);
std::string requestOnWire(std::string_view service);
std::string replyOnWire(std::string_view service);
/// @return "/scan" for "rt/scan"; nothing if it is not a ROS topic. The second function does the same for the service
/// of a request topic.
std::optional<std::string> topicFromWire(std::string_view wireName);
std::optional<std::string> serviceFromWire(std::string_view wireName);

}  // namespace pongsim::ros2
