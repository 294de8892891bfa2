#include "pongsim/sensing/beam_scene.hh"

#include "sensing/scene.hh"
#include "sim/api/access.hh"

namespace pongsim {

struct BeamScene::Content {
  sim::Access& access;
  sensing::Scene scene = {};
  /// `Access::changes` at the last `rebuild`.
  std::uint64_t changes = 0;
};

BeamScene::BeamScene(const World& world) : content_(new Content{*world.access_}) {}

BeamScene::~BeamScene() = default;

void BeamScene::rebuild(Diagnostics& diagnostics) {
  content_->changes = content_->access.changes;
  content_->scene.build(content_->access.entities, content_->access.state, diagnostics);
}

void BeamScene::update() {
  // levels load and unload within a step, and a program that steps the simulation is not notified of that
  if (content_->changes != content_->access.changes) {
    Diagnostics none;
    rebuild(none);
  }
  content_->scene.update(content_->access.state);
}

void BeamScene::cast(const Sensor& sensor, std::span<const Vector3> directions, double minRange, double maxRange,
                     std::uint32_t visibilityMask, std::span<Echo> echoes) {
  const world::Entities& entities = content_->access.entities;
  world::Slot model = entities.links()[sim::slotOf(content_->access, sensor.link().id())].model;
  while (entities.models()[model].parent != world::kNoSlot) model = entities.models()[model].parent;
  content_->scene.cast({sensor.pose(), entities.models()[model].id, minRange, maxRange, visibilityMask}, directions,
                       echoes);
}

}  // namespace pongsim
