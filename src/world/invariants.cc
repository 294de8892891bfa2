// What holds for the records between two changes; asserted after each, so it must not allocate.

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "world/entities.hh"

namespace pongsim::world {

namespace {

bool isIn(Slot slot, std::size_t size) { return slot == kNoSlot || slot < size; }

bool areIn(const std::vector<Slot>& slots, std::size_t size) {
  return std::ranges::all_of(slots, [size](Slot slot) { return slot < size; });
}

/// @return Whether a part that exists is set aside like what it is part of.
template <class Record>
bool goesWith(bool isSetAside, const std::vector<Record>& records, Slot slot) {
  return slot == kNoSlot || records[slot].isSetAside == isSetAside;
}

}  // namespace

bool Entities::isConsistent() const {
  const auto isIndexed = [this](const auto& records) {
    const auto ids = [](const auto& record) { return record.id.value; };
    if (std::ranges::adjacent_find(records, std::ranges::greater_equal(), ids) != records.end()) return false;
    for (Slot slot = 0; slot < records.size(); ++slot) {
      if (slotOfId_.find(records[slot].id.value) != slot) return false;
    }
    return true;
  };
  const auto isModelSound = [this](const ModelRecord& model) {
    const auto own = static_cast<Slot>(&model - models_.data());
    return (model.parent == kNoSlot || model.parent < own) && isIn(model.canonicalLink, links_.size()) &&
           areIn(model.links, links_.size()) && areIn(model.joints, joints_.size()) &&
           areIn(model.models, models_.size()) && goesWith(model.isSetAside, models_, model.parent);
  };
  const auto isLinkSound = [this](const LinkRecord& link) {
    const std::size_t count = link.description->collisions.size();
    return link.model < models_.size() && (count == 0 || link.firstCollision + count <= collisions_.size()) &&
           goesWith(link.isSetAside, models_, link.model);
  };
  const auto isJointSound = [this](const JointRecord& joint) {
    return isIn(joint.model, models_.size()) &&
           std::ranges::all_of(std::array{joint.parentLink, joint.childLink, joint.referenceLink}, [&](Slot link) {
             return isIn(link, links_.size()) && goesWith(joint.isSetAside, links_, link);
           });
  };
  const auto isOnLink = [this](const auto& record) {
    return isIn(record.link, links_.size()) && goesWith(record.isSetAside, links_, record.link);
  };
  const auto isOnJoint = [this](const SensorRecord& sensor) {
    return isIn(sensor.joint, joints_.size()) && goesWith(sensor.isSetAside, joints_, sensor.joint);
  };
  return isIndexed(models_) && isIndexed(links_) && isIndexed(joints_) && isIndexed(collisions_) &&
         isIndexed(sensors_) && isIndexed(lights_) && std::ranges::all_of(models_, isModelSound) &&
         std::ranges::all_of(links_, isLinkSound) && std::ranges::all_of(joints_, isJointSound) &&
         std::ranges::all_of(collisions_, isOnLink) && std::ranges::all_of(sensors_, isOnLink) &&
         std::ranges::all_of(sensors_, isOnJoint) && std::ranges::all_of(lights_, isOnLink) &&
         areIn(topLevelModels_, models_.size());
}

}  // namespace pongsim::world
