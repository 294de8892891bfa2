// Entities that are not there for a while: those of unloaded levels.

#include <algorithm>
#include <cassert>
#include <utility>
#include <vector>

#include "world/entities.hh"

namespace pongsim::world {

// What is part of something is set aside with it; a parent comes before its parts.
Entities::Switched Entities::setAside(const std::vector<std::uint64_t>& ids) {
  const auto isListed = [&](auto id) { return std::ranges::binary_search(ids, id.value); };
  const std::vector<std::uint64_t> before = listSetAside();
  Switched switched;
  for (ModelRecord& model : models_) {
    model.isSetAside = model.parent == kNoSlot ? isListed(model.id) : models_[model.parent].isSetAside;
  }
  for (Slot slot = 0; slot < links_.size(); ++slot) {
    const bool goes = models_[links_[slot].model].isSetAside;
    if (goes != std::exchange(links_[slot].isSetAside, goes)) {
      (goes ? switched.setAside : switched.returned).push_back(slot);
    }
  }
  for (JointRecord& joint : joints_) {
    const Slot link = joint.childLink != kNoSlot ? joint.childLink : joint.parentLink;
    joint.isSetAside =
        joint.model != kNoSlot ? models_[joint.model].isSetAside : link != kNoSlot && links_[link].isSetAside;
  }
  for (CollisionRecord& collision : collisions_) collision.isSetAside = links_[collision.link].isSetAside;
  for (SensorRecord& sensor : sensors_) {
    sensor.isSetAside = sensor.link != kNoSlot ? links_[sensor.link].isSetAside : joints_[sensor.joint].isSetAside;
  }
  for (LightRecord& light : lights_) {
    light.isSetAside = light.link != kNoSlot ? links_[light.link].isSetAside : isListed(light.id);
  }
  for (ActorRecord& actor : actors_) actor.isSetAside = isListed(actor.id);
  topLevelModels_.clear();
  for (const ModelRecord& model : present(models_)) {
    if (model.parent == kNoSlot) topLevelModels_.push_back(static_cast<Slot>(&model - models_.data()));
  }
  assert(isConsistent());
  switched.isAny = listSetAside() != before;
  return switched;
}

std::vector<std::uint64_t> Entities::listSetAside() const {
  std::vector<std::uint64_t> ids;
  for (const ModelRecord& model : models_) {
    if (model.isSetAside && model.parent == kNoSlot) ids.push_back(model.id.value);
  }
  for (const LightRecord& light : lights_) {
    if (light.isSetAside && light.link == kNoSlot) ids.push_back(light.id.value);
  }
  for (const ActorRecord& actor : actors_) {
    if (actor.isSetAside) ids.push_back(actor.id.value);
  }
  std::ranges::sort(ids);
  return ids;
}

bool Entities::isSetAside(std::uint64_t id) const {
  const auto is = [id](const auto& records) {
    const auto found = std::ranges::lower_bound(records, id, {}, [](const auto& record) { return record.id.value; });
    return found != records.end() && found->id.value == id && found->isSetAside;
  };
  return is(models_) || is(links_) || is(joints_) || is(collisions_) || is(sensors_) || is(actors_);
}

bool Entities::isSetAside(std::string_view scopedName) const {
  const auto found = modelOfName_.find(std::string(scopedName));
  return found != modelOfName_.end() && isSetAside(found->second.value);
}

bool Entities::isTaken(std::string_view name) const {
  return modelOfName_.contains(std::string(name)) || std::ranges::any_of(lights_, [name](const LightRecord& light) {
           return light.link == kNoSlot && light.description->name == name;
         });
}

}  // namespace pongsim::world
