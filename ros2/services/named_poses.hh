#pragma once

#include <string>

#include "ros2/services/entity_finder.hh"
#include "ros2/types/simulation_entity_services.hh"

namespace pongsim::ros2 {

/// @return The `<frame>`s of the world and its models without links, where they are now. None has tags.
simulation_interfaces::srv::GetNamedPoses::Response namedPoses(const EntityFinder& finder,
                                                               const simulation_interfaces::TagsFilter& tags);

/// @return Empty bounds, for a frame has none, where there is such a pose.
simulation_interfaces::srv::GetNamedPoseBounds::Response namedPoseBounds(const EntityFinder& finder,
                                                                         const std::string& name);

}  // namespace pongsim::ros2
