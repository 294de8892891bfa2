#include "world/entities.hh"

#include <algorithm>
#include <cassert>
#include <span>
#include <stdexcept>
#include <utility>

namespace pongsim::world {

namespace {

/// Splits "outer::inner::link" at the last "::".
struct ScopedName {
  explicit ScopedName(std::string_view name) {
    const std::size_t separator = name.rfind("::");
    if (separator == std::string_view::npos) {
      last = name;
    } else {
      scope = name.substr(0, separator);
      last = name.substr(separator + 2);
    }
  }
  std::string_view scope;
  std::string_view last;
};

std::string join(std::string_view outer, std::string_view inner) {
  if (outer.empty()) return std::string(inner);
  if (inner.empty()) return std::string(outer);
  return std::string(outer).append("::").append(inner);
}

}  // namespace

Entities::Entities(const description::World& world) : description_(&world), worldId_{nextId()} { addAll(); }

void Entities::addAll() {
  for (const description::Model& model : description_->models) {
    topLevelModels_.push_back(addModel(model, kNoSlot, Pose()));
  }
  for (const description::Joint& joint : description_->joints) addJoint(joint, kNoSlot);
  addLights(description_->lights, kNoSlot);
  for (const description::Actor& actor : description_->actors) {
    actors_.push_back({ActorId{nextId()}, &actor});
    lastId_ += actor.visuals.size();
  }
}

Slot Entities::addModel(const description::Model& description, Slot parent, const Pose& X_WorldParent) {
  const Slot slot = models_.size();
  const Pose X_WorldModel = X_WorldParent * description.X_ParentModel;

  ModelRecord record;
  record.id = ModelId{nextId()};
  record.description = &description;
  record.parent = parent;
  record.scopedName = description.name;
  record.isStatic = description.isStatic;
  if (parent != kNoSlot) {
    record.scopedName = join(models_[parent].scopedName, description.name);
    record.isStatic = record.isStatic || models_[parent].isStatic;
  }
  models_.push_back(std::move(record));
  slotOfId_.add(models_[slot].id.value, slot);
  modelOfName_.emplace(models_[slot].scopedName, models_[slot].id);

  addLinks(slot, X_WorldModel);
  for (const description::Model& inner : description.models) {
    const Slot innerSlot = addModel(inner, slot, X_WorldModel);
    models_[slot].models.push_back(innerSlot);
  }

  // joints come after the nested models whose links they may name
  for (const description::Joint& joint : description.joints) addJoint(joint, slot);

  const Slot canonical = findLink(slot, description.canonicalLink);
  if (canonical == kNoSlot && !description.canonicalLink.empty()) {
    throw std::invalid_argument("model '" + models_[slot].scopedName + "' has no canonical link '" +
                                description.canonicalLink + "'");
  }
  models_[slot].canonicalLink = canonical;
  models_[slot].X_CanonicalModel =
      canonical == kNoSlot ? X_WorldModel : links_[canonical].X_WorldLinkStart.inverse() * X_WorldModel;
  models_[slot].lastId = lastId_;
  return slot;
}

void Entities::addLinks(Slot model, const Pose& X_WorldModel) {
  for (const description::Link& link : models_[model].description->links) {
    const Slot slot = links_.size();
    links_.push_back(
        {LinkId{nextId()}, &link, model, models_[model].isStatic, X_WorldModel * link.X_ModelLink, collisions_.size()});
    slotOfId_.add(links_.back().id.value, slot);
    models_[model].links.push_back(slot);
    lastId_ += link.visuals.size() + link.emitters.size();
    for (const description::Collision& collision : link.collisions) {
      collisions_.push_back({CollisionId{nextId()}, &collision, slot});
      slotOfId_.add(collisions_.back().id.value, collisions_.size() - 1);
    }
    addLights(link.lights, slot);
    addSensors(link.sensors, slot, kNoSlot);
  }
}

void Entities::addJoint(const description::Joint& description, Slot model, std::optional<JointId> id) {
  const auto linkNamed = [&](const std::string& name) {
    if (name == "world") return kNoSlot;
    const Slot link = findLink(model, name);
    if (link == kNoSlot) {
      throw std::invalid_argument("joint '" + description.name + "' names a link '" + name + "' that isn't there");
    }
    return link;
  };
  const Slot slot = joints_.size();
  const Slot reference =
      description.type == description::JointType::kGearbox ? linkNamed(description.gearboxReference) : kNoSlot;
  const Slot parent = linkNamed(description.parent);
  const Slot child = linkNamed(description.child);
  if (id) lastId_ = std::max(lastId_, id->value);
  joints_.push_back({id ? *id : JointId{nextId()}, nullptr, &description, model, parent, child, reference});
  slotOfId_.add(joints_.back().id.value, slot);
  if (model != kNoSlot) {
    models_[model].joints.push_back(slot);
  } else {
    worldJoints_.push_back(joints_.back().id);
  }
  addSensors(description.sensors, kNoSlot, slot);
}

void Entities::addSensors(const std::vector<description::Sensor>& sensors, Slot link, Slot joint) {
  for (const description::Sensor& sensor : sensors) {
    sensors_.push_back({SensorId{nextId()}, &sensor, link, joint});
    slotOfId_.add(sensors_.back().id.value, sensors_.size() - 1);
  }
}

void Entities::addLights(const std::vector<description::Light>& lights, Slot link) {
  for (const description::Light& light : lights) addLight(light, link);
}

void Entities::addLight(const description::Light& light, Slot link) {
  lights_.push_back({LightId{nextId()}, nullptr, &light, link});
  slotOfId_.add(lights_.back().id.value, lights_.size() - 1);
}

template <class Add>
void Entities::addAllOrNothing(Add add) {
  const Extent before = extent();
  try {
    add();
  } catch (...) {
    undoInsertions(before);
    throw;
  }
  assert(isConsistent());
}

Slot Entities::insertModel(std::shared_ptr<const description::Model> model) {
  const Slot slot = models_.size();
  addAllOrNothing([&] {
    addModel(*model, kNoSlot, Pose());
    topLevelModels_.push_back(slot);
  });
  models_[slot].owner = std::move(model);
  return slot;
}

Slot Entities::insertJoint(std::shared_ptr<const description::Joint> joint, std::optional<JointId> id) {
  addAllOrNothing([&] { addJoint(*joint, kNoSlot, id); });
  joints_.back().owner = std::move(joint);
  return joints_.size() - 1;
}

Slot Entities::insertLight(std::shared_ptr<const description::Light> light) {
  addAllOrNothing([&] { addLight(*light, kNoSlot); });
  lights_.back().owner = std::move(light);
  return lights_.size() - 1;
}

Entities::Extent Entities::extent() const {
  return {models_.size(),      links_.size(),          joints_.size(),
          collisions_.size(),  sensors_.size(),        lights_.size(),
          worldJoints_.size(), topLevelModels_.size(), lastId_};
}

// What was inserted stands behind what was there. Nothing here allocates.
void Entities::undoInsertions(const Extent& before) noexcept {
  for (Slot slot = before.models; slot < models_.size(); ++slot) {
    const auto named = modelOfName_.find(models_[slot].scopedName);
    if (named != modelOfName_.end() && named->second == models_[slot].id) modelOfName_.erase(named);
  }
  const auto shorten = [this](auto& records, std::size_t size) {
    for (std::size_t slot = size; slot < records.size(); ++slot) slotOfId_.remove(records[slot].id.value);
    records.erase(records.begin() + static_cast<std::ptrdiff_t>(size), records.end());
  };
  shorten(models_, before.models);
  shorten(links_, before.links);
  shorten(joints_, before.joints);
  shorten(collisions_, before.collisions);
  shorten(sensors_, before.sensors);
  shorten(lights_, before.lights);
  worldJoints_.resize(before.worldJoints);
  topLevelModels_.resize(before.topLevelModels);
  lastId_ = before.lastId;
  assert(isConsistent());
}

void Entities::changeLight(Slot light, std::shared_ptr<const description::Light> changed) {
  lights_[light].description = changed.get();
  lights_[light].owner = std::move(changed);
}

void Entities::changeLink(Slot link, std::shared_ptr<const description::Link> changed) {
  LinkRecord& record = links_[link];
  if (record.changed == nullptr) record.ofFile = record.description;
  record.description = changed == nullptr ? record.ofFile : changed.get();
  for (std::size_t i = 0; i < record.description->collisions.size(); ++i) {
    collisions_[record.firstCollision + i].description = &record.description->collisions[i];
  }
  record.changed = std::move(changed);
}

void Entities::collectModels(Slot model, std::vector<Slot>& models) const {
  models.push_back(model);
  for (const Slot inner : models_[model].models) collectModels(inner, models);
}

std::span<const JointRecord> Entities::jointsAround(Slot link) const {
  Slot root = links_[link].model;
  while (models_[root].parent != kNoSlot) root = models_[root].parent;
  const auto id = [](const JointRecord& joint) { return joint.id.value; };
  const auto first = std::ranges::lower_bound(joints_, models_[root].id.value, {}, id);
  return {first, std::ranges::upper_bound(first, joints_.end(), models_[root].lastId, {}, id)};
}

std::vector<Slot> Entities::allLinks(Slot model) const {
  std::vector<Slot> models;
  collectModels(model, models);
  std::vector<Slot> links;
  for (const Slot each : models) links.insert(links.end(), models_[each].links.begin(), models_[each].links.end());
  return links;
}

void Entities::reset() {
  Entities start(*description_);
  start.lastId_ = std::max(start.lastId_, lastId_);
  start.removals_ = removals_ + 1;
  *this = std::move(start);
}

namespace {

/// @return The slot of `id` in `records`, if it is one of theirs and not set aside.
template <class Records, class Id>
Slot slotIn(const Records& records, const IdIndex& slotOfId, Id id) {
  const Slot slot = slotOfId.find(id.value);
  return slot < records.size() && records[slot].id == id && !records[slot].isSetAside ? slot : kNoSlot;
}

}  // namespace

Slot Entities::slot(ModelId id) const { return slotIn(models_, slotOfId_, id); }
Slot Entities::slot(LinkId id) const { return slotIn(links_, slotOfId_, id); }
Slot Entities::slot(JointId id) const { return slotIn(joints_, slotOfId_, id); }
Slot Entities::slot(CollisionId id) const { return slotIn(collisions_, slotOfId_, id); }
Slot Entities::slot(SensorId id) const { return slotIn(sensors_, slotOfId_, id); }
Slot Entities::slot(LightId id) const { return slotIn(lights_, slotOfId_, id); }

Slot Entities::findModel(std::string_view scopedName) const {
  const auto found = modelOfName_.find(std::string(scopedName));
  return found == modelOfName_.end() ? kNoSlot : slot(found->second);
}

const std::string& Entities::nameSpace(Slot model) const {
  static const std::string none;
  if (model == kNoSlot) return none;
  while (models_[model].parent != kNoSlot) model = models_[model].parent;
  return models_[model].description->nameSpace;
}

Slot Entities::findLink(Slot model, std::string_view name) const {
  const ScopedName scoped(name);
  const Slot holder = findModel(join(model == kNoSlot ? "" : models_[model].scopedName, scoped.scope));
  if (holder == kNoSlot) return kNoSlot;
  for (Slot link : models_[holder].links) {
    if (links_[link].description->name == scoped.last) return link;
  }
  return kNoSlot;
}

Slot Entities::findLink(std::string_view name) const { return findLink(kNoSlot, name); }

Slot Entities::findJoint(Slot model, std::string_view name) const {
  const ScopedName scoped(name);
  const std::string holderName = join(model == kNoSlot ? "" : models_[model].scopedName, scoped.scope);
  const Slot holder = findModel(holderName);
  if (holder == kNoSlot && !holderName.empty()) return kNoSlot;
  if (holder == kNoSlot) {
    for (const JointId id : worldJoints_) {
      const Slot joint = slot(id);
      if (joint != kNoSlot && joints_[joint].description->name == scoped.last) return joint;
    }
    return kNoSlot;
  }
  for (const Slot joint : models_[holder].joints) {
    if (joints_[joint].description->name == scoped.last) return joint;
  }
  return kNoSlot;
}

Slot Entities::findLight(Slot link, std::string_view name) const {
  // those of a link follow it and its visuals and collisions
  const std::uint64_t first = link == kNoSlot ? 0 : links_[link].id.value;
  const auto begin =
      std::ranges::lower_bound(lights_, first, {}, [](const LightRecord& light) { return light.id.value; });
  for (auto light = begin; light != lights_.end(); ++light) {
    if (light->link == link && light->description->name == name && !light->isSetAside)
      return static_cast<Slot>(light - lights_.begin());
    if (link != kNoSlot && light->link != link) break;
  }
  return kNoSlot;
}

}  // namespace pongsim::world
