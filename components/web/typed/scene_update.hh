#pragma once

#include <foxglove/scene.pb.h>
#include <ignition/msgs/scene.pb.h>

#include <cstdint>

namespace pongsim::web::typed {

/// @return The whole scene, replacing the previous one: an entity for each link, in the link's frame as named by
/// `Frames` and locked to it. Leaves out what Foxglove has no primitive for: heightmaps, polylines, lights.
::foxglove::SceneUpdate sceneUpdate(const ignition::msgs::Scene& scene, std::uint64_t timeNs);

}  // namespace pongsim::web::typed
