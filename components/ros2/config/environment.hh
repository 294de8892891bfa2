#pragma once

#include <string>
#include <vector>

#include "ros2/wire/participant.hh"

namespace pongsim::ros2 {

/// @return The options set by ROS_DOMAIN_ID, ROS_LOCALHOST_ONLY, ROS_AUTOMATIC_DISCOVERY_RANGE, ROS_STATIC_PEERS and
/// PONGSIM_NETWORK.
/// @throws std::invalid_argument for a domain that is not between 0 and 232, or a range that is none.
ParticipantOptions participantOptionsOfEnvironment();

/// @return What of ROS's, Fast DDS's and Cyclone's variables can't be done with these options, a sentence for each.
std::vector<std::string> unmetVariables(const ParticipantOptions& options);

}  // namespace pongsim::ros2
