#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace pongsim::ros2 {

/// Where participants tell which nodes they are, and which endpoints are whose.
inline constexpr const char* kDiscoveryTopic = "ros_discovery_info";

/// @return What is wrong with an absolute name of ROS ("has a '-'"), or nothing.
std::optional<std::string> rosNameError(std::string_view name);

/// @return `name` where it is absolute, else within the namespace ("/" or "/robot").
std::string absoluteName(std::string_view nameSpace, std::string_view name);

/// @return A name of ROS for a topic of the simulation: what ROS does not allow becomes '_', and a word that begins
/// with a digit gets one in front.
std::string rosNameFor(std::string_view topic);

// Names on the wire.
std::string topicOnWire(std::string_view name);
std::string requestOnWire(std::string_view service);
std::string replyOnWire(std::string_view service);
/// @return Of "rt/scan" "/scan"; nothing where it is no topic of ROS. Likewise of a request topic the service.
std::optional<std::string> topicFromWire(std::string_view wireName);
std::optional<std::string> serviceFromWire(std::string_view wireName);

}  // namespace pongsim::ros2
