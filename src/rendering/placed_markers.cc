#include "rendering/placed_markers.hh"

#include <algorithm>
#include <string_view>
#include <utility>

namespace pongsim::rendering {

std::optional<Pose> markerParentPose(const std::string& parent, const world::Entities& entities,
                                     const world::State& state) {
  if (parent.empty()) return Pose();
  const world::Slot model = entities.findModel(parent);
  if (model != world::kNoSlot) return world::modelPose(entities, state, model);
  world::Slot link = entities.findLink(std::string_view(parent));
  if (link != world::kNoSlot) return state.links[link].X_WorldLink;
  const std::size_t colons = parent.rfind("::");
  if (colons == std::string::npos) return std::nullopt;
  link = entities.findLink(std::string_view(parent).substr(0, colons));
  if (link == world::kNoSlot) return std::nullopt;
  const std::vector<description::Visual>& visuals = entities.links()[link].description->visuals;
  const auto visual = std::ranges::find(visuals, parent.substr(colons + 2), &description::Visual::name);
  if (visual == visuals.end()) return std::nullopt;
  return state.links[link].X_WorldLink * visual->X_LinkVisual;
}

Eigen::Affine3d PlacedMarker::X_WorldPart(const MarkerPart& part, const Quaternion& R_WorldEye) const {
  // seen from the front, y of the text is to the left, as that of the eye is
  const Quaternion rotation = part.facesEye ? R_WorldEye : X_WorldMarker.rotation;
  return Eigen::Translation3d(X_WorldMarker.position) * rotation * Eigen::Scaling(marker->scale) * part.X_MarkerPart;
}

bool PlacedMarkers::update(const MarkerList& markers, const world::Entities& entities, const world::State& state) {
  if (markers.empty() && all_.empty()) return false;
  all_.clear();
  bool isOther = false;
  auto before = std::exchange(parts_, {});
  for (const std::shared_ptr<const world::Marker>& marker : markers) {
    auto known = before.extract(marker);
    isOther |= known.empty();
    if (known.empty()) {
      parts_[marker] = std::make_shared<const std::vector<MarkerPart>>(maker_.of(*marker));
    } else {
      parts_.insert(std::move(known));
    }
    const std::optional<Pose> parent = markerParentPose(marker->parent, entities, state);
    if (parent) all_.push_back({marker, parts_[marker], *parent * marker->X_ParentMarker});
  }
  return isOther || !before.empty();
}

}  // namespace pongsim::rendering
