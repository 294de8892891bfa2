#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "ros2/wire/participant.hh"

namespace pongsim::ros2 {

/// @return What a distribution's name means on the wire; nothing for a name that none has.
std::optional<Distro> distroNamed(std::string_view name);

/// @return All names that `distroNamed` knows.
std::span<const std::string_view> distroNames();

/// @return What ROS_DOMAIN_ID, ROS_LOCALHOST_ONLY, ROS_DISTRO and PONGSIM_NETWORK say.
/// @throws std::invalid_argument for a domain that is none from 0 to 232.
ParticipantOptions participantOptionsOfEnvironment();

}  // namespace pongsim::ros2
