#include "pongsim/scene.hh"

#include <algorithm>
#include <string>
#include <utility>

#include "msgs/scene/emitter_message.hh"
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

std::vector<EmitterPlace> Scene::emitters() const {
  std::vector<EmitterPlace> places;
  for (const world::Emitter& emitter : access_->particlesNow().emitters()) {
    if (access_->entities.slot(emitter.link) == world::kNoSlot) continue;
    places.push_back({emitter.id, emitter.now.name, emitter.link, emitter.now.topic});
  }
  return places;
}

void Scene::fillInEmitter(EmitterId id, Message& emitter) const {
  const world::Emitter* found = access_->particlesNow().find(id);
  if (found == nullptr)
    throw Gone("the particle emitter with the id " + std::to_string(id.value) + " no longer exists");
  msgs::setEmitter(found->now, id.value, emitter);
}

Outcome<void> Scene::changeEmitter(EmitterId id, const Message& emitter) {
  world::Emitter* found = access_->particlesNow().find(id);
  if (found == nullptr) return {"there is no particle emitter with the id " + std::to_string(id.value)};
  description::ParticleEmitter changed = msgs::changedEmitter(found->now, emitter);
  if (const std::string fault = description::faultOf(changed); !fault.empty()) return {fault};
  if (msgs::beginsEmission(emitter)) found->since = access_->state.time;
  msgs::mergeEmitter(emitter, found->changes);
  found->now = std::move(changed);
  return {};
}

const Semantics& Scene::semantics(ModelId model) const {
  return access_->entities.models()[sim::slotOf(*access_, model)].description->semantics;
}

std::uint64_t Scene::colorChanges() const { return access_->colorChanges; }

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
