#include "pongsim/scene.hh"

#include <algorithm>

#include "msgs/scene/full_path.hh"
#include "msgs/scene/gui_message.hh"
#include "msgs/scene/scene_message.hh"
#include "msgs/state/state_message.hh"
#include "sim/api/access.hh"

namespace pongsim {

Scene::Scene(const World& world) : access_(world.access_) {}

namespace {

msgs::ChangedProperties changedProperties(const sim::Access& access) {
  msgs::ChangedProperties changed{access.colors, {}};
  const std::vector<world::LinkRecord>& links = access.entities.links();
  for (world::Slot slot = 0; slot < links.size(); ++slot) {
    const physics::Engine::Mass now = access.engine.mass(slot);
    // 0 for a link that does not move
    if (now.mass == 0 || (now.mass == links[slot].description->inertial.mass && now.inertiaFactor == 1)) continue;
    changed.masses[links[slot].id] = {now.mass, now.inertiaFactor};
  }
  return changed;
}

}  // namespace

void Scene::fillIn(Message& scene, const std::function<bool(std::uint64_t)>& isWanted) const {
  msgs::setScene(access_->entities, access_->state, scene, isWanted, {access_->colors, {}});
}

void Scene::fillInState(Message& step, StateContent content, bool isPaused) const {
  const bool isAll = content == StateContent::kAll;
  msgs::setState(access_->entities, access_->state, content, isPaused, step,
                 isAll ? changedProperties(*access_) : msgs::ChangedProperties());
}

void Scene::fillInGui(Message& gui) const { msgs::setGui(access_->entities.description().gui, gui); }

std::string Scene::graph() const { return msgs::sceneGraph(access_->entities); }

std::vector<LightPlace> Scene::lights() const {
  std::vector<LightPlace> places;
  for (const world::LightRecord& light : world::present(access_->entities.lights())) {
    places.push_back({light.id, light.description->name, light.description->X_ParentLight});
  }
  std::ranges::sort(places, {}, &LightPlace::id);
  return places;
}

std::vector<ActorPlace> Scene::actors() const {
  std::vector<ActorPlace> places;
  for (const world::ActorRecord& actor : world::present(access_->entities.actors())) {
    places.push_back({actor.id, actor.description->name, msgs::pathOf(actor.description->skin)});
  }
  return places;
}

const Semantics& Scene::semantics(ModelId model) const {
  return access_->entities.models()[sim::slotOf(*access_, model)].description->semantics;
}

std::vector<std::uint64_t> Scene::topLevelIds() const {
  std::vector<std::uint64_t> ids;
  for (const world::Slot model : access_->entities.topLevelModels()) {
    ids.push_back(access_->entities.models()[model].id.value);
  }
  for (const world::LightRecord& light : world::present(access_->entities.lights())) {
    if (light.link == world::kNoSlot) ids.push_back(light.id.value);
  }
  std::ranges::sort(ids);
  return ids;
}

}  // namespace pongsim
