#include "world/entities.hh"

#include <stdexcept>

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

Entities::Entities(const description::World& world) : description_(&world), worldId_{nextId()} {
  for (const description::Model& model : world.models) topLevelModels_.push_back(addModel(model, kNoSlot, Pose()));
  for (const description::Joint& joint : world.joints) addJoint(joint, kNoSlot);
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
  slotOfId_.emplace(record.id.value, slot);
  modelOfName_.emplace(record.scopedName, slot);
  models_.push_back(std::move(record));

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
  return slot;
}

void Entities::addLinks(Slot model, const Pose& X_WorldModel) {
  for (const description::Link& link : models_[model].description->links) {
    const Slot slot = links_.size();
    links_.push_back(
        {LinkId{nextId()}, &link, model, models_[model].isStatic, X_WorldModel * link.X_ModelLink, collisions_.size()});
    slotOfId_.emplace(links_.back().id.value, slot);
    models_[model].links.push_back(slot);
    lastId_ += link.visuals.size();
    for (const description::Collision& collision : link.collisions) {
      collisions_.push_back({CollisionId{nextId()}, &collision, slot});
      slotOfId_.emplace(collisions_.back().id.value, collisions_.size() - 1);
    }
    addSensors(link.sensors, slot, kNoSlot);
  }
}

void Entities::addJoint(const description::Joint& description, Slot model) {
  const auto linkNamed = [&](const std::string& name) {
    if (name == "world") return kNoSlot;
    const Slot link = findLink(model, name);
    if (link == kNoSlot) {
      throw std::invalid_argument("joint '" + description.name + "' names a link '" + name + "' that isn't there");
    }
    return link;
  };
  const Slot slot = joints_.size();
  joints_.push_back(
      {JointId{nextId()}, &description, model, linkNamed(description.parent), linkNamed(description.child)});
  slotOfId_.emplace(joints_.back().id.value, slot);
  if (model != kNoSlot) models_[model].joints.push_back(slot);
  addSensors(description.sensors, kNoSlot, slot);
}

void Entities::addSensors(const std::vector<description::Sensor>& sensors, Slot link, Slot joint) {
  for (const description::Sensor& sensor : sensors) {
    sensors_.push_back({SensorId{nextId()}, &sensor, link, joint});
    slotOfId_.emplace(sensors_.back().id.value, sensors_.size() - 1);
  }
}

namespace {

/// @return The slot of `id` in `records`, if it is one of theirs.
template <class Records, class Id>
Slot slotIn(const Records& records, const std::unordered_map<std::uint64_t, Slot>& slotOfId, Id id) {
  const auto found = slotOfId.find(id.value);
  if (found == slotOfId.end() || found->second >= records.size() || records[found->second].id != id) return kNoSlot;
  return found->second;
}

}  // namespace

Slot Entities::slot(ModelId id) const { return slotIn(models_, slotOfId_, id); }
Slot Entities::slot(LinkId id) const { return slotIn(links_, slotOfId_, id); }
Slot Entities::slot(JointId id) const { return slotIn(joints_, slotOfId_, id); }
Slot Entities::slot(CollisionId id) const { return slotIn(collisions_, slotOfId_, id); }
Slot Entities::slot(SensorId id) const { return slotIn(sensors_, slotOfId_, id); }

Slot Entities::findModel(std::string_view scopedName) const {
  const auto found = modelOfName_.find(std::string(scopedName));
  return found == modelOfName_.end() ? kNoSlot : found->second;
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
  for (Slot joint = 0; joint < joints_.size(); ++joint) {
    if (joints_[joint].model == holder && joints_[joint].description->name == scoped.last) return joint;
  }
  return kNoSlot;
}

}  // namespace pongsim::world
