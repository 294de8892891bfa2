#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "ros2/wire/participant.hh"

namespace pongsim::ros2 {

/// @return The wire format of a distribution; nothing for an unknown name.
std::optional<Distro> distroNamed(std::string_view name);

/// @return All names known to `distroNamed`.
std::span<const std::string_view> distroNames();

/// @return The options set by ROS_DOMAIN_ID, ROS_LOCALHOST_ONLY, ROS_DISTRO and PONGSIM_NETWORK.
/// @throws std::invalid_argument for a domain that is not between 0 and 232.
ParticipantOptions participantOptionsOfEnvironment();

}  // namespace pongsim::ros2
