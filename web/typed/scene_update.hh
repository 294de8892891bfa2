#pragma once

#include <foxglove/scene.pb.h>
#include <ignition/msgs/scene.pb.h>

#include <cstdint>

namespace pongsim::web::typed {

/// @return All of the scene, in place of what was there: an entity for each link, in its frame as `Frames` names it and
/// locked to it. Left out is what Foxglove has no shape for: heightmaps, polylines, lights.
::foxglove::SceneUpdate sceneUpdate(const ignition::msgs::Scene& scene, std::uint64_t timeNs);

}  // namespace pongsim::web::typed
