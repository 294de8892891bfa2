#include "sim/edits/editor.hh"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace pongsim::sim {

bool isSound(const Pose& pose) {
  return pose.position.allFinite() && pose.rotation.coeffs().allFinite() && pose.rotation.norm() > 1e-6;
}

bool Editor::isFree(std::string_view name) const {
  const auto isOf = [name](const Shelved& shelved) {
    return std::ranges::any_of(shelved.entities.models,
                               [name](const world::ModelRecord& model) { return model.scopedName == name; }) ||
           std::ranges::any_of(shelved.entities.lights, [name](const world::LightRecord& light) {
             return light.link == world::kNoSlot && light.description->name == name;
           });
  };
  return access_.entities.findModel(name) == world::kNoSlot &&
         access_.entities.findLight(world::kNoSlot, name) == world::kNoSlot &&
         std::ranges::none_of(access_.shelf, isOf);
}

std::string Editor::freeName(const std::string& name) const {
  if (isFree(name)) return name;
  if (access_.takenNames.removals != access_.entities.removals()) {
    access_.takenNames = {.removals = access_.entities.removals(), .counts = {}};
  }
  // whoever inserts thousands of copies does not try all names each time
  int& number = access_.takenNames.counts[name];
  std::string free;
  for (;; ++number) {
    free = name + "_" + std::to_string(number);
    if (isFree(free)) return free;
  }
}

world::Slot Editor::insert(std::shared_ptr<const description::Model> model) {
  const world::Slot slot = access_.entities.insertModel(std::move(model));
  try {
    access_.engine.grow();
  } catch (...) {
    access_.entities.removeModel(slot);
    throw;
  }
  access_.state.grow(access_.entities);
  access_.noteChange();
  return slot;
}

std::vector<ModelId> Editor::remove(const std::vector<world::Slot>& models) {
  const world::Removal removal = access_.entities.removeModels(models);
  access_.engine.remove(removal);
  access_.state.remove(removal);
  access_.noteChange();
  return removal.models;
}

const world::JointRecord* Editor::holder(const std::vector<world::Slot>& links) const {
  const world::Entities& entities = access_.entities;
  const auto isOf = [&](world::Slot link) { return std::ranges::binary_search(links, link); };
  const auto holds = [&](const world::JointRecord& joint) { return isOf(joint.parentLink) != isOf(joint.childLink); };
  const std::span<const world::JointRecord> around = entities.jointsAround(links.front());
  const auto found = std::ranges::find_if(around, holds);
  if (found != around.end()) return &*found;
  for (const JointId id : entities.worldJoints()) {
    const world::JointRecord& joint = entities.joints()[entities.slot(id)];
    if (holds(joint)) return &joint;
  }
  return nullptr;
}

void Editor::move(const std::vector<world::Slot>& links, const Pose& X_NewOld, AfterMove after) {
  for (const world::Slot link : links) {
    world::LinkState& state = access_.state.links[link];
    state.X_WorldLink = X_NewOld * state.X_WorldLink;
    const bool stops = after == AfterMove::kStop;
    state.v_WorldLink = stops ? Vector3::Zero() : Vector3(X_NewOld.rotation * state.v_WorldLink);
    state.w_WorldLink = stops ? Vector3::Zero() : Vector3(X_NewOld.rotation * state.w_WorldLink);
    access_.engine.setLinkPose(link, state.X_WorldLink);
    access_.engine.setLinkVelocity(link, state.v_WorldLink, state.w_WorldLink);
  }
}

std::optional<std::string> Editor::setPose(world::Slot model, const Pose& X_WorldModel, AfterMove after) {
  if (!isSound(X_WorldModel)) return "the pose is not finite";
  const Pose X_WorldNew{X_WorldModel.position, X_WorldModel.rotation.normalized()};
  std::vector<world::Slot> links = access_.entities.allLinks(model);
  std::ranges::sort(links);
  if (links.empty()) {
    access_.entities.setPose(model, X_WorldNew);
    return std::nullopt;
  }
  if (const world::JointRecord* joint = holder(links)) {
    return "model '" + access_.entities.models()[model].scopedName + "' is held by joint '" + joint->description->name +
           "'";
  }
  move(links, X_WorldNew * world::modelPose(access_.entities, access_.state, model).inverse(), after);
  return std::nullopt;
}

std::optional<std::string> Editor::setLinkPose(world::Slot link, const Pose& X_WorldLink, AfterMove after) {
  if (!isSound(X_WorldLink)) return "the pose is not finite";
  if (const world::JointRecord* joint = holder({link})) {
    return "link '" + access_.entities.links()[link].description->name + "' is held by joint '" +
           joint->description->name + "'";
  }
  const Pose X_WorldNew{X_WorldLink.position, X_WorldLink.rotation.normalized()};
  move({link}, X_WorldNew * access_.state.links[link].X_WorldLink.inverse(), after);
  return std::nullopt;
}

world::Slot Editor::attach(world::Slot parent, world::Slot child, std::string name) {
  const auto scopedName = [&](world::Slot link) {
    const world::LinkRecord& record = access_.entities.links()[link];
    return access_.entities.models()[record.model].scopedName + "::" + record.description->name;
  };
  auto joint = std::make_shared<description::Joint>();
  for (int number = 0; name.empty(); ++number) {
    std::string candidate = "attachment_" + std::to_string(number);
    if (access_.entities.findJoint(world::kNoSlot, candidate) == world::kNoSlot) name = std::move(candidate);
  }
  joint->name = std::move(name);
  joint->type = description::JointType::kFixed;
  joint->parent = scopedName(parent);
  joint->child = scopedName(child);
  const std::vector<world::LinkState>& links = access_.state.links;
  joint->X_ParentJoint = links[parent].X_WorldLink.inverse() * links[child].X_WorldLink;
  return insertJoint(std::move(joint));
}

world::Slot Editor::insertJoint(std::shared_ptr<const description::Joint> joint, std::optional<JointId> id) {
  const world::Slot slot = access_.entities.insertJoint(std::move(joint), id);
  access_.engine.grow();
  access_.state.grow(access_.entities);
  access_.noteChange();
  return slot;
}

void Editor::detach(world::Slot joint) {
  const world::Removal removal = access_.entities.removeJoint(joint);
  access_.engine.remove(removal);
  access_.state.remove(removal);
  access_.noteChange();
}

void Editor::setGravity(const Vector3& gravity) {
  access_.state.gravity = gravity;
  access_.engine.setGravity(gravity);
}

namespace {

/// @return The lowest id in it.
std::uint64_t firstId(const world::Records& records) {
  std::uint64_t first = std::numeric_limits<std::uint64_t>::max();
  for (const world::ModelRecord& model : records.models) first = std::min(first, model.id.value);
  for (const world::LightRecord& light : records.lights) first = std::min(first, light.id.value);
  for (const world::ActorRecord& actor : records.actors) first = std::min(first, actor.id.value);
  return first;
}

}  // namespace

void Editor::setAside(const std::vector<world::Roots>& groups) {
  if (groups.empty()) return;
  world::Departure departure = access_.entities.setAside(groups);
  std::vector<physics::SetAside> bodies = access_.engine.setAside(departure.slots);
  std::vector<world::StatePart> state = access_.state.setAside(departure.slots);
  for (std::size_t i = 0; i < groups.size(); ++i) {
    access_.shelf.push_back({std::move(departure.groups[i]), std::move(state[i]), std::move(bodies[i])});
  }
  putShelfInOrder();
}

void Editor::bringBack(const std::vector<std::size_t>& places) {
  if (places.empty()) return;
  std::vector<world::Records> entities;
  std::vector<world::StatePart> state;
  std::vector<physics::SetAside> bodies;
  for (const std::size_t place : places) {
    entities.push_back(std::move(access_.shelf[place].entities));
    state.push_back(std::move(access_.shelf[place].state));
    bodies.push_back(std::move(access_.shelf[place].bodies));
  }
  world::eraseSlots(access_.shelf, places);
  const world::GroupSlots slots = access_.entities.bringBack(std::move(entities));
  access_.engine.bringBack(slots, std::move(bodies));
  access_.state.bringBack(slots, std::move(state));
  putShelfInOrder();
}

void Editor::putShelfInOrder() {
  std::ranges::sort(access_.shelf, {}, [](const Shelved& shelved) { return firstId(shelved.entities); });
  access_.shelvedIds.clear();
  for (const Shelved& shelved : access_.shelf) {
    for (const world::ModelRecord& model : shelved.entities.models) access_.shelvedIds.insert(model.id.value);
    for (const world::SensorRecord& sensor : shelved.entities.sensors) access_.shelvedIds.insert(sensor.id.value);
    for (const world::ActorRecord& actor : shelved.entities.actors) access_.shelvedIds.insert(actor.id.value);
  }
  access_.noteChange();
}

void Editor::reset() {
  access_.shelf.clear();
  access_.shelvedIds.clear();
  access_.entities.reset();
  // the systems stay, and with them the batteries of the models that are there
  std::vector<world::BatteryState> batteries = std::move(access_.state.batteries);
  std::erase_if(batteries, [this](const world::BatteryState& battery) {
    return access_.entities.slot(battery.model) == world::kNoSlot;
  });
  access_.state = world::State(access_.entities);
  access_.state.batteries = std::move(batteries);
  access_.engine.reset();
  access_.noteChange();
}

void Editor::cutPower() {
  for (const world::BatteryState& battery : access_.state.batteries) {
    if (battery.charge > 0 || !world::isOutOfPower(access_.state, battery.model)) continue;
    const world::Slot model = access_.entities.slot(battery.model);
    if (model == world::kNoSlot) continue;
    for (const world::Slot joint : access_.entities.models()[model].joints) access_.engine.releaseJoint(joint);
  }
}

}  // namespace pongsim::sim
