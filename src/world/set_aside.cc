// Entities that leave the arrays for a while and come back.

#include <algorithm>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include "world/entities.hh"

namespace pongsim::world {

namespace {

/// In place of a group: what stays.
constexpr std::size_t kStays = std::numeric_limits<std::size_t>::max();

/// Something for each slot of each kind.
struct BySlot {
  std::vector<std::size_t> models, links, joints, collisions, sensors, lights, actors;
};

/// Tells of each slot which group it goes with: what hangs on something goes with that.
BySlot groupsOf(const Records& records, const std::vector<Roots>& roots) {
  BySlot group;
  group.models.assign(records.models.size(), kStays);
  group.lights.assign(records.lights.size(), kStays);
  group.actors.assign(records.actors.size(), kStays);
  for (std::size_t i = 0; i < roots.size(); ++i) {
    for (const Slot slot : roots[i].models) group.models[slot] = i;
    for (const Slot slot : roots[i].lights) group.lights[slot] = i;
    for (const Slot slot : roots[i].actors) group.actors[slot] = i;
  }
  for (Slot slot = 0; slot < records.models.size(); ++slot) {
    // who holds it stands before it
    if (const Slot parent = records.models[slot].parent; parent != kNoSlot) group.models[slot] = group.models[parent];
  }
  for (const LinkRecord& link : records.links) group.links.push_back(group.models[link.model]);
  for (const JointRecord& joint : records.joints) {
    const Slot link = joint.childLink != kNoSlot ? joint.childLink : joint.parentLink;
    group.joints.push_back(joint.model != kNoSlot ? group.models[joint.model]
                           : link != kNoSlot      ? group.links[link]
                                                  : kStays);
  }
  for (const CollisionRecord& collision : records.collisions) group.collisions.push_back(group.links[collision.link]);
  for (const SensorRecord& sensor : records.sensors) {
    group.sensors.push_back(sensor.link != kNoSlot ? group.links[sensor.link] : group.joints[sensor.joint]);
  }
  for (Slot slot = 0; slot < records.lights.size(); ++slot) {
    if (const Slot link = records.lights[slot].link; link != kNoSlot) group.lights[slot] = group.links[link];
  }
  return group;
}

/// Shares the records of a kind out.
/// @param member The kind, in `Records`.
/// @param stay, groups Where they go.
/// @return The slot that each has there.
template <class Record>
std::vector<Slot> shareOut(std::vector<Record>& records, const std::vector<std::size_t>& groupOf,
                           std::vector<Record> Records::*member, Records& stay, std::vector<Records>& groups) {
  std::vector<Slot> newSlots;
  newSlots.reserve(records.size());
  for (Slot slot = 0; slot < records.size(); ++slot) {
    std::vector<Record>& target = (groupOf[slot] == kStays ? stay : groups[groupOf[slot]]).*member;
    newSlots.push_back(target.size());
    target.push_back(std::move(records[slot]));
  }
  return newSlots;
}

void renumberOne(Slot& slot, const std::vector<Slot>& newSlots) {
  if (slot != kNoSlot) slot = newSlots[slot];
}

void renumberAll(std::vector<Slot>& slots, const std::vector<Slot>& newSlots) {
  for (Slot& slot : slots) slot = newSlots[slot];
}

/// Lets records name each other by their new slots.
void renumberRecords(Records& records, const BySlot& to) {
  for (ModelRecord& model : records.models) {
    renumberOne(model.parent, to.models);
    renumberOne(model.canonicalLink, to.links);
    renumberAll(model.links, to.links);
    renumberAll(model.joints, to.joints);
    renumberAll(model.models, to.models);
  }
  for (LinkRecord& link : records.links) {
    renumberOne(link.model, to.models);
    // that of a link without any may be behind the last one
    if (!link.description->collisions.empty()) renumberOne(link.firstCollision, to.collisions);
  }
  for (JointRecord& joint : records.joints) {
    renumberOne(joint.model, to.models);
    for (Slot* link : {&joint.parentLink, &joint.childLink, &joint.referenceLink}) renumberOne(*link, to.links);
  }
  for (CollisionRecord& collision : records.collisions) renumberOne(collision.link, to.links);
  for (SensorRecord& sensor : records.sensors) {
    renumberOne(sensor.link, to.links);
    renumberOne(sensor.joint, to.joints);
  }
  for (LightRecord& light : records.lights) renumberOne(light.link, to.links);
}

/// @return The slots of a kind, group by group.
std::vector<std::vector<Slot>> slotsByGroup(const std::vector<std::size_t>& groupOf, std::size_t count) {
  std::vector<std::vector<Slot>> slots(count);
  for (Slot slot = 0; slot < groupOf.size(); ++slot) {
    if (groupOf[slot] != kStays) slots[groupOf[slot]].push_back(slot);
  }
  return slots;
}

/// @return Of each part, the slots that its records of a kind have when all are put together in the order of their ids.
template <class Record>
std::vector<std::vector<Slot>> mergedSlots(const std::vector<Records>& parts, std::vector<Record> Records::*member) {
  std::vector<std::tuple<std::uint64_t, std::size_t, Slot>> all;
  std::vector<std::vector<Slot>> slots(parts.size());
  for (std::size_t part = 0; part < parts.size(); ++part) {
    const std::vector<Record>& records = parts[part].*member;
    slots[part].resize(records.size());
    for (Slot slot = 0; slot < records.size(); ++slot) all.emplace_back(records[slot].id.value, part, slot);
  }
  std::ranges::sort(all);
  for (Slot place = 0; place < all.size(); ++place) slots[std::get<1>(all[place])][std::get<2>(all[place])] = place;
  return slots;
}

template <class Record>
void merge(std::vector<Records>& parts, const std::vector<std::vector<Slot>>& slots,
           std::vector<Record> Records::*member, Records& whole) {
  std::size_t count = 0;
  for (const Records& part : parts) count += (part.*member).size();
  (whole.*member).resize(count);
  for (std::size_t part = 0; part < parts.size(); ++part) {
    std::vector<Record>& records = parts[part].*member;
    for (Slot slot = 0; slot < records.size(); ++slot) (whole.*member)[slots[part][slot]] = std::move(records[slot]);
  }
}

}  // namespace

Records Entities::takeRecords() {
  return {std::move(models_),  std::move(links_),  std::move(joints_), std::move(collisions_),
          std::move(sensors_), std::move(lights_), std::move(actors_)};
}

void Entities::giveRecords(Records records) {
  models_ = std::move(records.models);
  links_ = std::move(records.links);
  joints_ = std::move(records.joints);
  collisions_ = std::move(records.collisions);
  sensors_ = std::move(records.sensors);
  lights_ = std::move(records.lights);
  actors_ = std::move(records.actors);
  topLevelModels_.clear();
  for (Slot slot = 0; slot < models_.size(); ++slot) {
    if (models_[slot].parent == kNoSlot) topLevelModels_.push_back(slot);
  }
  index();
}

Departure Entities::setAside(const std::vector<Roots>& groups) {
  Records whole = takeRecords();
  const BySlot group = groupsOf(whole, groups);
  Departure departure{std::vector<Records>(groups.size()),
                      {slotsByGroup(group.links, groups.size()), slotsByGroup(group.joints, groups.size())}};
  Records stay;
  BySlot to;
  to.models = shareOut(whole.models, group.models, &Records::models, stay, departure.groups);
  to.links = shareOut(whole.links, group.links, &Records::links, stay, departure.groups);
  to.joints = shareOut(whole.joints, group.joints, &Records::joints, stay, departure.groups);
  to.collisions = shareOut(whole.collisions, group.collisions, &Records::collisions, stay, departure.groups);
  shareOut(whole.sensors, group.sensors, &Records::sensors, stay, departure.groups);
  shareOut(whole.lights, group.lights, &Records::lights, stay, departure.groups);
  shareOut(whole.actors, group.actors, &Records::actors, stay, departure.groups);
  renumberRecords(stay, to);
  for (Records& records : departure.groups) renumberRecords(records, to);
  giveRecords(std::move(stay));
  return departure;
}

GroupSlots Entities::bringBack(std::vector<Records> groups) {
  // what is there goes first
  std::vector<Records> parts;
  parts.push_back(takeRecords());
  std::ranges::move(groups, std::back_inserter(parts));
  const auto models = mergedSlots(parts, &Records::models);
  auto links = mergedSlots(parts, &Records::links);
  auto joints = mergedSlots(parts, &Records::joints);
  const auto collisions = mergedSlots(parts, &Records::collisions);
  for (std::size_t part = 0; part < parts.size(); ++part) {
    BySlot to;
    to.models = models[part];
    to.links = links[part];
    to.joints = joints[part];
    to.collisions = collisions[part];
    renumberRecords(parts[part], to);
  }
  Records whole;
  merge(parts, mergedSlots(parts, &Records::sensors), &Records::sensors, whole);
  merge(parts, mergedSlots(parts, &Records::lights), &Records::lights, whole);
  merge(parts, mergedSlots(parts, &Records::actors), &Records::actors, whole);
  merge(parts, models, &Records::models, whole);
  merge(parts, links, &Records::links, whole);
  merge(parts, joints, &Records::joints, whole);
  merge(parts, collisions, &Records::collisions, whole);
  giveRecords(std::move(whole));
  links.erase(links.begin());
  joints.erase(joints.begin());
  return {std::move(links), std::move(joints)};
}

}  // namespace pongsim::world
