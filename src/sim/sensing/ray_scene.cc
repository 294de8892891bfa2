#include "pongsim/sensing/ray_scene.hh"

#include "sensing/scene.hh"
#include "sim/api/access.hh"

namespace pongsim {

struct RayScene::Content {
  sim::Access& access;
  sensing::Scene scene = {};
  /// `Access::changes` when the visuals were read.
  std::optional<std::uint64_t> changes = std::nullopt;
};

RayScene::RayScene(const World& world) : content_(new Content{*world.access_}) {}

RayScene::~RayScene() = default;

void RayScene::cast(std::span<const Ray> rays, double farthest, std::uint32_t visibilityMask, std::span<RayHit> hits,
                    Diagnostics& diagnostics) {
  const sim::Access& access = content_->access;
  if (content_->changes != access.changes) {
    content_->scene.build(access.entities, access.state, diagnostics);
    content_->changes = access.changes;
  }
  content_->scene.update(access.state);
  content_->scene.cast(rays, farthest, visibilityMask, [&](std::size_t ray, const sensing::Beam& beam) {
    hits[ray] = RayHit();
    if (beam.hit == nullptr) return;
    hits[ray].distance = beam.range;
    if (beam.hit->link != world::kNoSlot) hits[ray].link = access.entities.links()[beam.hit->link].id;
  });
}

}  // namespace pongsim
