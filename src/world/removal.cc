// Entities that go for good.

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "world/entities.hh"

namespace pongsim::world {

namespace {

/// @return The first record with that id or a larger one, and all behind it.
template <class Record>
std::span<Record> recordsFrom(std::vector<Record>& records, std::uint64_t id) {
  const auto first = std::ranges::lower_bound(records, id, {}, [](const Record& record) { return record.id.value; });
  return {first, records.end()};
}

/// Notes the slots of the records whose ids are from `first` to `last`.
template <class Record>
void noteSlots(std::vector<Record>& records, std::uint64_t first, std::uint64_t last, std::vector<Slot>& slots) {
  const std::span<Record> found = recordsFrom(records, first);
  Slot slot = records.size() - found.size();
  for (const Record& record : found) {
    if (record.id.value > last) return;
    slots.push_back(slot++);
  }
}

/// The slot that is `old` once these slots have gone.
Slot movedUp(Slot old, const std::vector<Slot>& gone) {
  if (old == kNoSlot || gone.empty() || old < gone.front()) return old;
  const auto before = std::ranges::lower_bound(gone, old);
  return old - static_cast<Slot>(before - gone.begin());
}

/// Likewise for slots in ascending order, some of which may have gone.
void moveUp(std::vector<Slot>& slots, const std::vector<Slot>& gone) {
  if (gone.empty() || slots.empty() || slots.back() < gone.front()) return;
  const auto first = std::ranges::lower_bound(slots, gone.front());
  const auto goes = [&](Slot slot) { return std::ranges::binary_search(gone, slot); };
  slots.erase(std::remove_if(first, slots.end(), goes), slots.end());
  for (auto slot = first; slot != slots.end(); ++slot) *slot = movedUp(*slot, gone);
}

}  // namespace

Removal Entities::removeModels(const std::vector<Slot>& models) {
  Removal removal;
  if (models.empty()) return removal;
  Gone gone;
  std::vector<std::pair<std::uint64_t, std::uint64_t>> joints;
  for (const Slot model : models) {
    const std::uint64_t first = models_[model].id.value;
    const std::uint64_t last = models_[model].lastId;
    removal.descriptions.push_back(models_[model].owner);
    noteSlots(models_, first, last, gone.models);
    noteSlots(links_, first, last, gone.links);
    noteSlots(collisions_, first, last, gone.collisions);
    noteSlots(lights_, first, last, gone.lights);
    joints.emplace_back(first, last);
  }
  std::uint64_t from = models_[models.front()].id.value;
  const auto goes = [&](Slot link) { return std::ranges::binary_search(gone.links, link); };
  for (const JointId id : worldJoints_) {
    const JointRecord& joint = joints_[slotOfId_.find(id.value)];
    if (!goes(joint.parentLink) && !goes(joint.childLink) && !goes(joint.referenceLink)) continue;
    joints.emplace_back(id.value, id.value + joint.description->sensors.size());
    from = std::min(from, id.value);
  }
  std::ranges::sort(joints);
  for (const auto& [firstOfJoint, lastOfJoint] : joints) {
    noteSlots(joints_, firstOfJoint, lastOfJoint, gone.joints);
    noteSlots(sensors_, firstOfJoint, lastOfJoint, gone.sensors);
  }
  for (const Slot link : gone.links) {
    if (links_[link].changed != nullptr) removal.descriptions.push_back(links_[link].changed);
  }
  for (const Slot each : gone.models) removal.models.push_back(models_[each].id);
  removal.links = gone.links;
  removal.joints = gone.joints;
  remove(gone, from);
  return removal;
}

Removal Entities::removeJoint(Slot joint) {
  Removal removal;
  removal.joints = {joint};
  removal.descriptions = {joints_[joint].owner};
  const std::uint64_t id = joints_[joint].id.value;
  Slot root = joints_[joint].model;
  while (root != kNoSlot && models_[root].parent != kNoSlot) root = models_[root].parent;
  Gone gone;
  gone.joints = {joint};
  noteSlots(sensors_, id, id + joints_[joint].description->sensors.size(), gone.sensors);
  remove(gone, root == kNoSlot ? id : models_[root].id.value);
  return removal;
}

void Entities::removeLight(Slot light) {
  Gone gone;
  gone.lights = {light};
  remove(gone, lights_[light].id.value);
}

template <class Record>
void Entities::erase(std::vector<Record>& records, const std::vector<Slot>& slots) {
  if (slots.empty()) return;
  for (const Slot slot : slots) slotOfId_.remove(records[slot].id.value);
  eraseSlots(records, slots);
  for (Slot slot = slots.front(); slot < records.size(); ++slot) slotOfId_.move(records[slot].id.value, slot);
}

void Entities::remove(const Gone& gone, std::uint64_t from) {
  ++removals_;
  for (const Slot model : gone.models) modelOfName_.erase(models_[model].scopedName);
  std::erase_if(worldJoints_,
                [&](JointId id) { return std::ranges::binary_search(gone.joints, slotOfId_.find(id.value)); });
  erase(models_, gone.models);
  erase(links_, gone.links);
  erase(joints_, gone.joints);
  erase(collisions_, gone.collisions);
  erase(sensors_, gone.sensors);
  erase(lights_, gone.lights);
  renumber(gone, from);
  assert(isConsistent());
}

// All are in the order of their ids, so that what stands before the first that goes names nothing behind it.
void Entities::renumber(const Gone& gone, std::uint64_t from) {
  moveUp(topLevelModels_, gone.models);
  for (ModelRecord& model : recordsFrom(models_, from)) {
    model.parent = movedUp(model.parent, gone.models);
    model.canonicalLink = movedUp(model.canonicalLink, gone.links);
    moveUp(model.links, gone.links);
    moveUp(model.joints, gone.joints);
    moveUp(model.models, gone.models);
  }
  for (LinkRecord& link : recordsFrom(links_, from)) {
    link.model = movedUp(link.model, gone.models);
    link.firstCollision = movedUp(link.firstCollision, gone.collisions);
  }
  for (JointRecord& joint : recordsFrom(joints_, from)) renumberJoint(joint, gone);
  for (const JointId id : worldJoints_) {
    if (id.value < from) renumberJoint(joints_[slotOfId_.find(id.value)], gone);
  }
  for (CollisionRecord& collision : recordsFrom(collisions_, from)) {
    collision.link = movedUp(collision.link, gone.links);
  }
  for (SensorRecord& sensor : recordsFrom(sensors_, from)) {
    sensor.link = movedUp(sensor.link, gone.links);
    sensor.joint = movedUp(sensor.joint, gone.joints);
  }
  for (LightRecord& light : recordsFrom(lights_, from)) light.link = movedUp(light.link, gone.links);
}

void Entities::renumberJoint(JointRecord& joint, const Gone& gone) {
  joint.model = movedUp(joint.model, gone.models);
  for (Slot* link : {&joint.parentLink, &joint.childLink, &joint.referenceLink}) *link = movedUp(*link, gone.links);
}

}  // namespace pongsim::world
