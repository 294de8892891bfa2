#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

#include "rendering/marker_parts.hh"
#include "world/entities.hh"
#include "world/markers.hh"
#include "world/state.hh"

namespace pongsim::rendering {

using MarkerList = std::vector<std::shared_ptr<const world::Marker>>;

/// @return Pose of what a marker names as its parent: "model", "model::link" or "model::link::visual", or the world if
/// that is empty; nothing if there is none.
std::optional<Pose> markerParentPose(const std::string& parent, const world::Entities& entities,
                                     const world::State& state);

/// A marker where it is seen.
struct PlacedMarker {
  std::shared_ptr<const world::Marker> marker;
  std::shared_ptr<const std::vector<MarkerPart>> parts;
  Pose X_WorldMarker;

  /// @return From the frame of a part to the world.
  Eigen::Affine3d X_WorldPart(const MarkerPart& part, const Quaternion& R_WorldEye) const;
};

/// The markers of a scene. Those whose parent does not exist are not seen.
class PlacedMarkers {
 public:
  /// @return Whether others are there than before.
  bool update(const MarkerList& markers, const world::Entities& entities, const world::State& state);

  std::span<const PlacedMarker> all() const { return all_; }

 private:
  MarkerParts maker_;
  std::unordered_map<std::shared_ptr<const world::Marker>, std::shared_ptr<const std::vector<MarkerPart>>> parts_;
  std::vector<PlacedMarker> all_;
};

}  // namespace pongsim::rendering
