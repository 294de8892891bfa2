#pragma once

#include <string>

#include "ros2/services/entity_finder.hh"
#include "ros2/types/simulation_entity_services.hh"

namespace pongsim::ros2 {

/// @return The current poses of the world's `<frame>`s and of its models without links. None has tags.
simulation_interfaces::srv::GetNamedPoses::Response namedPoses(const EntityFinder& finder,
                                                               const simulation_interfaces::TagsFilter& tags);

/// @return Empty bounds if the pose exists, because a frame has no extent.
simulation_interfaces::srv::GetNamedPoseBounds::Response namedPoseBounds(const EntityFinder& finder,
                                                                         const std::string& name);

}  // namespace pongsim::ros2
