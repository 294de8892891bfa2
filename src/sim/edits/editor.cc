#include "sim/edits/editor.hh"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "description/limits.hh"

namespace pongsim::sim {

const char* poseFault(const Pose& pose) {
  const bool isFinite =
      pose.position.allFinite() && pose.rotation.coeffs().allFinite() && pose.rotation.coeffs().stableNorm() > 1e-6;
  if (!isFinite || !std::isfinite(pose.rotation.norm())) return "is not finite";
  if (pose.position.cwiseAbs().maxCoeff() > description::kLargestPosition) return "is not within 1e9 m of the origin";
  return nullptr;
}

bool Editor::isFree(std::string_view name) const { return !access_.entities.isTaken(name); }

std::string Editor::freeName(const std::string& name) const {
  if (isFree(name)) return name;
  if (access_.takenNames.removals != access_.entities.removals()) {
    access_.takenNames = {.removals = access_.entities.removals(), .counts = {}};
  }
  // remembers where to continue, so that inserting n copies takes O(n) attempts
  int& number = access_.takenNames.counts[name];
  std::string free;
  for (;; ++number) {
    free = name + "_" + std::to_string(number);
    if (isFree(free)) return free;
  }
}

void Editor::noteChange() {
  assert(access_.state.links.size() == access_.entities.links().size());
  assert(access_.state.joints.size() == access_.entities.joints().size());
  access_.noteChange();
}

template <class Insert>
world::Slot Editor::insertAllOrNothing(Insert insert) {
  const world::Entities::Extent before = access_.entities.extent();
  try {
    const world::Slot slot = insert();
    access_.state.grow(access_.entities);
    // undoes its own changes if it fails
    access_.engine.grow();
    noteChange();
    return slot;
  } catch (...) {
    access_.entities.undoInsertions(before);
    access_.state.undoInsertions(access_.entities);
    throw;
  }
}

world::Slot Editor::insert(std::shared_ptr<const description::Model> model) {
  return insertAllOrNothing([&] { return access_.entities.insertModel(std::move(model)); });
}

std::vector<ModelId> Editor::remove(const std::vector<world::Slot>& models) {
  world::Removal removal = access_.entities.removeModels(models);
  // nothing below allocates, so the removal can't fail halfway
  access_.engine.remove(removal);
  access_.state.remove(removal);
  noteChange();
  return std::move(removal.models);
}

const world::JointRecord* Editor::holder(const std::vector<world::Slot>& links) const {
  const world::Entities& entities = access_.entities;
  const auto isOf = [&](world::Slot link) { return std::ranges::binary_search(links, link); };
  const auto holds = [&](const world::JointRecord& joint) { return isOf(joint.parentLink) != isOf(joint.childLink); };
  const std::span<const world::JointRecord> around = entities.jointsAround(links.front());
  const auto found = std::ranges::find_if(around, holds);
  if (found != around.end()) return &*found;
  for (const JointId id : entities.worldJoints()) {
    const world::Slot slot = entities.slot(id);
    if (slot != world::kNoSlot && holds(entities.joints()[slot])) return &entities.joints()[slot];
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

Outcome<void> Editor::setPose(world::Slot model, const Pose& X_WorldModel, AfterMove after) {
  if (const char* fault = poseFault(X_WorldModel)) return {std::string("the pose ") + fault};
  const Pose X_WorldNew{X_WorldModel.position, X_WorldModel.rotation.normalized()};
  std::vector<world::Slot> links = access_.entities.allLinks(model);
  std::ranges::sort(links);
  if (links.empty()) {
    access_.entities.setPose(model, X_WorldNew);
    return {};
  }
  if (const world::JointRecord* joint = holder(links)) {
    return {"model '" + access_.entities.models()[model].scopedName + "' is held by joint '" +
            joint->description->name + "'"};
  }
  move(links, X_WorldNew * world::modelPose(access_.entities, access_.state, model).inverse(), after);
  return {};
}

Outcome<void> Editor::setLinkPose(world::Slot link, const Pose& X_WorldLink, AfterMove after) {
  if (const char* fault = poseFault(X_WorldLink)) return {std::string("the pose ") + fault};
  if (const world::JointRecord* joint = holder({link})) {
    return {"link '" + access_.entities.links()[link].description->name + "' is held by joint '" +
            joint->description->name + "'"};
  }
  const Pose X_WorldNew{X_WorldLink.position, X_WorldLink.rotation.normalized()};
  move({link}, X_WorldNew * access_.state.links[link].X_WorldLink.inverse(), after);
  return {};
}

void Editor::setLinkVelocity(world::Slot link, const Vector3& linear, const Vector3& angular) {
  if (!access_.engine.setLinkVelocity(link, linear, angular)) return;
  access_.state.links[link].v_WorldLink = linear;
  access_.state.links[link].w_WorldLink = angular;
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
  return insertAllOrNothing([&] { return access_.entities.insertJoint(std::move(joint), id); });
}

void Editor::detach(world::Slot joint) {
  const world::Removal removal = access_.entities.removeJoint(joint);
  access_.engine.remove(removal);
  access_.state.remove(removal);
  noteChange();
}

void Editor::setGravity(const Vector3& gravity) {
  access_.state.gravity = gravity;
  access_.engine.setGravity(gravity);
}

void Editor::setAside(const std::vector<std::uint64_t>& ids) {
  const world::Entities::Switched switched = access_.entities.setAside(ids);
  if (!switched.isAny) return;
  access_.engine.setAside(switched);
  noteChange();
}

void Editor::reset() {
  access_.entities.reset();
  // systems are not made again, so batteries that they have added stay, if their models exist
  std::vector<world::BatteryState> batteries = std::move(access_.state.batteries);
  std::erase_if(batteries, [this](const world::BatteryState& battery) {
    return access_.entities.slot(battery.model) == world::kNoSlot;
  });
  access_.state = world::State(access_.entities);
  access_.state.batteries = std::move(batteries);
  access_.engine.reset();
  noteChange();
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
