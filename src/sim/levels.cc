#include "sim/levels.hh"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "pongsim/log.hh"
#include "sim/api/access.hh"
#include "sim/edits/editor.hh"
#include "world/actor_motion.hh"

namespace pongsim::sim {

namespace {

const Logger& levelLog() {
  static const Logger log("levels");
  return log;
}

Eigen::AlignedBox3d boxAround(const Vector3& center, const Vector3& size) {
  return {center - size / 2, center + size / 2};
}

const world::ActorRecord* actorNamed(const world::Entities& entities, std::string_view name) {
  const auto found = std::ranges::find_if(
      entities.actors(), [name](const world::ActorRecord& actor) { return actor.description->name == name; });
  return found == entities.actors().end() ? nullptr : &*found;
}

/// @return For each model the number of its cluster: the lowest slot among the top-level models that joints connect,
/// directly or through others. Nested models are in the cluster of their parent.
std::vector<world::Slot> clustersOf(const world::Entities& entities) {
  std::vector<world::Slot> parents(entities.models().size());
  for (world::Slot slot = 0; slot < parents.size(); ++slot) {
    const world::Slot outer = entities.models()[slot].parent;
    parents[slot] = outer == world::kNoSlot ? slot : parents[outer];
  }
  const auto rootOf = [&parents](world::Slot slot) {
    while (parents[slot] != slot) slot = parents[slot] = parents[parents[slot]];
    return slot;
  };
  for (const world::JointRecord& joint : entities.joints()) {
    world::Slot first = world::kNoSlot;
    for (const world::Slot link : {joint.parentLink, joint.childLink, joint.referenceLink}) {
      if (link == world::kNoSlot) continue;
      const world::Slot root = rootOf(entities.links()[link].model);
      if (first != world::kNoSlot) parents[std::max(first, root)] = std::min(first, root);
      first = rootOf(root);
    }
  }
  for (world::Slot slot = 0; slot < parents.size(); ++slot) parents[slot] = rootOf(slot);
  return parents;
}

}  // namespace

void Levels::start() {
  readZones();
  readPerformers();
  awaited_.clear();
  isHeld_ = false;
  isNew_ = true;
  changes_ = access_.changes;
}

void Levels::readZones() {
  zones_.clear();
  members_.clear();
  if (!areUsed_) return;
  const world::Entities& entities = access_.entities;
  std::unordered_map<std::uint64_t, std::size_t> places;
  const auto add = [&](Kind kind, std::uint64_t id) {
    const auto [place, isNew] = places.emplace(id, members_.size());
    if (isNew) members_.push_back({kind, id, {}});
    members_[place->second].zones.push_back(zones_.size() - 1);
  };
  for (const description::Level& level : entities.description().levels.levels) {
    zones_.push_back({&level, boxAround(level.center, level.size),
                      boxAround(level.center, level.size + Vector3::Constant(2 * level.buffer))});
    for (const description::Level::Member& member : level.members) {
      if (const world::Slot model = entities.findModel(member.name); model != world::kNoSlot) {
        add(Kind::kModel, entities.models()[model].id.value);
      }
      if (const world::Slot light = entities.findLight(world::kNoSlot, member.name); light != world::kNoSlot) {
        add(Kind::kLight, entities.lights()[light].id.value);
      }
      if (const world::ActorRecord* actor = actorNamed(entities, member.name)) add(Kind::kActor, actor->id.value);
    }
  }
}

void Levels::readPerformers() {
  // performers added at run time end with a reset
  std::erase_if(performers_, [](const PerformerOfLevels& performer) { return !performer.isOfFile; });
  const std::vector<PerformerOfLevels> before = std::exchange(performers_, {});
  for (const description::Performer& performer : access_.entities.description().levels.performers) {
    PerformerOfLevels added;
    added.id = performers_.size() < before.size() ? before[performers_.size()].id : access_.entities.nextId();
    added.name = performer.name;
    added.size = performer.size;
    added.isOfFile = true;
    const world::Slot model = access_.entities.findModel(performer.ref);
    const world::ActorRecord* actor = actorNamed(access_.entities, performer.ref);
    if (model != world::kNoSlot) added.model = access_.entities.models()[model].id;
    added.actor = model == world::kNoSlot && actor != nullptr ? actor->description : nullptr;
    performers_.push_back(std::move(added));
  }
}

std::optional<Pose> Levels::poseOf(const PerformerOfLevels& performer) const {
  if (performer.actor != nullptr) return world::actorPose(*performer.actor, access_.state);
  const world::Slot slot = access_.entities.slot(performer.model);
  if (slot == world::kNoSlot) return std::nullopt;
  return world::modelPose(access_.entities, access_.state, slot);
}

bool Levels::isPerforming(ModelId model) const {
  return std::ranges::any_of(performers_,
                             [model](const PerformerOfLevels& performer) { return performer.model == model; });
}

Outcome<void> Levels::add(ModelId model, std::string name, const Vector3& size) {
  const world::Slot slot = access_.entities.slot(model);
  if (slot == world::kNoSlot) return {"the model no longer exists"};
  const world::ModelRecord& record = access_.entities.models()[slot];
  if (record.parent != world::kNoSlot) return {"model '" + record.scopedName + "' is part of another model"};
  if (isPerforming(model)) return {"model '" + record.scopedName + "' is already a performer"};
  if (!size.allFinite() || !(size.minCoeff() > 0)) return {"the size of a performer must be three numbers above zero"};
  if (name.empty()) name = "perf_" + record.scopedName;
  performers_.push_back({access_.entities.nextId(), std::move(name), model, nullptr, size, false});
  return {};
}

void Levels::addAwaited() {
  std::erase_if(awaited_, [&](const std::string& name) {
    const world::Slot slot = access_.entities.findModel(name);
    if (slot == world::kNoSlot || access_.entities.models()[slot].parent != world::kNoSlot) return false;
    const Outcome<void> added = add(access_.entities.models()[slot].id, {}, kPerformerSize);
    if (!added) levelLog().warning(added.error);
    return true;
  });
}

void Levels::listPerformers(std::vector<Performer>& performers) const {
  performers.clear();
  for (const PerformerOfLevels& each : performers_) {
    const std::optional<Pose> pose = poseOf(each);
    if (!pose) continue;
    performers.push_back(
        {each.id, each.name, each.actor == nullptr ? std::optional(each.model) : std::nullopt, *pose, each.size});
  }
}

std::vector<std::pair<std::string_view, bool>> Levels::list() const {
  std::vector<std::pair<std::string_view, bool>> levels;
  for (const Zone& zone : zones_) levels.emplace_back(zone.level->name, zone.isLoaded);
  return levels;
}

void Levels::update() {
  if (!awaited_.empty()) addAwaited();
  if (!areUsed_) return;
  const bool mayBeReleased = isHeld_ && changes_ != access_.changes;
  if (switchZones() || mayBeReleased || isNew_) rearrange();
  isNew_ = false;
  changes_ = access_.changes;
}

bool Levels::switchZones() {
  boxes_.clear();
  for (const PerformerOfLevels& performer : performers_) {
    const std::optional<Pose> pose = poseOf(performer);
    if (pose) boxes_.push_back(boxAround(pose->position, performer.size));
  }
  bool hasSwitched = false;
  for (Zone& zone : zones_) {
    const Eigen::AlignedBox3d& box = zone.isLoaded ? zone.outer : zone.inner;
    const bool isNear = std::ranges::any_of(boxes_, [&box](const auto& other) { return box.intersects(other); });
    if (isNear == zone.isLoaded) continue;
    zone.isLoaded = isNear;
    hasSwitched = true;
    levelLog().info("level '" + zone.level->name + (isNear ? "' is loaded" : "' is unloaded"));
  }
  return hasSwitched;
}

void Levels::rearrange() {
  const auto isWanted = [this](const Member& member) {
    return (member.kind == Kind::kModel && isPerforming(ModelId{member.id})) ||
           std::ranges::any_of(member.zones, [this](std::size_t zone) { return zones_[zone].isLoaded; });
  };
  std::vector<std::uint64_t> aside;
  for (const Member& member : members_) {
    if (!isWanted(member)) aside.push_back(member.id);
  }
  std::ranges::sort(aside);
  // a cluster is set aside if none of its models is in a loaded level
  const std::vector<world::ModelRecord>& models = access_.entities.models();
  const std::vector<world::Slot> clusters = clustersOf(access_.entities);
  std::vector<bool> stays(models.size());
  const auto isAside = [&](const world::ModelRecord& model) {
    return std::ranges::binary_search(aside, model.id.value);
  };
  for (world::Slot slot = 0; slot < models.size(); ++slot) {
    if (models[slot].parent == world::kNoSlot && !isAside(models[slot])) stays[clusters[slot]] = true;
  }
  isHeld_ = false;
  for (world::Slot slot = 0; slot < models.size(); ++slot) {
    if (models[slot].parent != world::kNoSlot || !stays[clusters[slot]]) continue;
    if (std::erase(aside, models[slot].id.value) > 0) isHeld_ = true;
  }
  Editor(access_).setAside(aside);
}

void Levels::transfer(StateArchive& archive) {
  for (Zone& zone : zones_) archive(zone.isLoaded);
  archive(awaited_);
  // forces the next `update` to evaluate again which entities joints keep
  if (archive.isGiving()) isHeld_ = true;
  std::vector<PerformerOfLevels> made;
  for (const PerformerOfLevels& performer : performers_) {
    if (!performer.isOfFile) made.push_back(performer);
  }
  std::size_t count = made.size();
  archive(count);
  archive.check(count <= archive.rest().size());
  if (archive.isGiving()) {
    made.assign(count, PerformerOfLevels());
    std::erase_if(performers_, [](const PerformerOfLevels& performer) { return !performer.isOfFile; });
  }
  for (PerformerOfLevels& performer : made) {
    const world::Slot slot = access_.entities.slot(performer.model);
    std::string model = slot == world::kNoSlot ? std::string() : access_.entities.models()[slot].scopedName;
    archive(performer.id);
    archive(performer.name);
    archive(performer.size);
    archive.check(performer.size.minCoeff() > 0);
    archive(model);
    if (!archive.isGiving()) continue;
    const world::Slot found = access_.entities.findModel(model);
    if (found != world::kNoSlot) performer.model = access_.entities.models()[found].id;
    performers_.push_back(performer);
  }
}

}  // namespace pongsim::sim
