#include "pongsim/sensing/beam_scene.hh"

#include <vector>

#include "sensing/scene.hh"
#include "sim/api/access.hh"
#include "sim/sensing/scatter.hh"

namespace pongsim {

struct BeamScene::Content {
  sim::Access& access;
  sensing::Scene scene = {};
  /// `Access::changes` at the last `rebuild`.
  std::uint64_t changes = 0;
  /// What was hit; kept for its memory.
  std::vector<world::Slot> links = {};

  sensing::Beams beamsOf(const Sensor& sensor, double minRange, double maxRange, std::uint32_t visibilityMask) const {
    const world::Entities& entities = access.entities;
    world::Slot model = entities.links()[sim::slotOf(access, sensor.link().id())].model;
    while (entities.models()[model].parent != world::kNoSlot) model = entities.models()[model].parent;
    return {sensor.pose(), entities.models()[model].id, minRange, maxRange, visibilityMask};
  }
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
  content_->scene.cast(content_->beamsOf(sensor, minRange, maxRange, visibilityMask), directions, echoes);
}

void BeamScene::cast(const Sensor& sensor, std::span<const Vector3> directions, double minRange, double maxRange,
                     std::uint32_t visibilityMask, std::span<Echo> echoes, std::span<std::optional<LinkId>> targets) {
  std::vector<world::Slot>& links = content_->links;
  links.resize(directions.size());
  content_->scene.cast(content_->beamsOf(sensor, minRange, maxRange, visibilityMask), directions, echoes, links);
  for (std::size_t i = 0; i < links.size(); ++i) {
    targets[i].reset();
    if (links[i] != world::kNoSlot) targets[i] = content_->access.entities.links()[links[i]].id;
  }
}

void BeamScene::scatter(const Sensor& sensor, std::span<const Vector3> directions, double minRange, double maxRange,
                        std::span<Echo> echoes) {
  if (content_->access.particlesNow().emitters().empty()) return;
  sim::Scatter scatter(content_->access, sensor.scopedName());
  if (scatter.isAnything()) scatter.apply(sensor.pose(), directions, minRange, maxRange, echoes);
}

}  // namespace pongsim
