#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "description/world.hh"
#include "pongsim/types.hh"
#include "world/id_index.hh"

namespace pongsim::world {

/// Place of a link, joint or model in the arrays of `Entities` and `State`.
using Slot = std::size_t;
/// In place of a slot: nothing, or the world itself.
inline constexpr Slot kNoSlot = std::numeric_limits<Slot>::max();

struct LinkRecord {
  LinkId id;
  const description::Link* description = nullptr;
  Slot model = kNoSlot;
  /// Its model, or one that holds it, is static.
  bool isStatic = false;
  /// Pose of the link frame in the world frame at the start.
  Pose X_WorldLinkStart;
  /// Slot of its first collision; the others follow.
  Slot firstCollision = 0;
};

struct JointRecord {
  JointId id;
  /// Keeps the description of a joint that was made while running.
  std::shared_ptr<const description::Joint> owner = nullptr;
  const description::Joint* description = nullptr;
  /// `kNoSlot` for a joint of the world itself.
  Slot model = kNoSlot;
  /// `kNoSlot` stands for the world.
  Slot parentLink = kNoSlot;
  Slot childLink = kNoSlot;
  /// Of a gearbox: what its axes are fixed to.
  Slot referenceLink = kNoSlot;
};

struct CollisionRecord {
  CollisionId id;
  const description::Collision* description = nullptr;
  Slot link = kNoSlot;
};

struct SensorRecord {
  SensorId id;
  const description::Sensor* description = nullptr;
  /// What holds it: either is `kNoSlot`.
  Slot link = kNoSlot;
  Slot joint = kNoSlot;
};

struct LightRecord {
  LightId id;
  /// Keeps the description of a light that was inserted or changed while running.
  std::shared_ptr<const description::Light> owner = nullptr;
  const description::Light* description = nullptr;
  /// Link that holds it; `kNoSlot` for a light of the world.
  Slot link = kNoSlot;
};

struct ActorRecord {
  ActorId id;
  const description::Actor* description = nullptr;
};

/// @return The id of one of the visuals of the actor's links.
inline VisualId visualId(const ActorRecord& actor, std::size_t visual) { return VisualId{actor.id.value + 1 + visual}; }

struct ModelRecord {
  ModelId id;
  /// Keeps the description of a model that was inserted while running; the models in it have none.
  std::shared_ptr<const description::Model> owner = nullptr;
  const description::Model* description = nullptr;
  /// `kNoSlot` for a model at the top level.
  Slot parent = kNoSlot;
  /// "outer::inner"
  std::string scopedName;
  bool isStatic = false;
  /// `kNoSlot` for a model without any link: it stands still in the world.
  Slot canonicalLink = kNoSlot;
  /// Pose of the model frame in the frame of its canonical link (in the world's, if it has none); never changes.
  Pose X_CanonicalModel;
  std::vector<Slot> links;
  std::vector<Slot> joints;
  std::vector<Slot> models;
};

/// @return The id of one of the link's visuals.
inline VisualId visualId(const LinkRecord& link, std::size_t visual) { return VisualId{link.id.value + 1 + visual}; }

/// What has gone: the slots that it had, in ascending order. Its descriptions live as long as this.
struct Removal {
  std::vector<Slot> links;
  std::vector<Slot> joints;
  std::vector<ModelId> models;
  std::shared_ptr<const void> descriptions;
};

/// Takes the entries of these slots, in ascending order, out of an array; those behind move up.
template <class Array>
void eraseSlots(Array& array, const std::vector<Slot>& slots) {
  if (slots.empty()) return;
  std::size_t gone = 0;
  std::size_t kept = slots.front();
  for (Slot slot = slots.front(); slot < array.size(); ++slot) {
    if (gone < slots.size() && slots[gone] == slot) {
      ++gone;
      continue;
    }
    if (kept != slot) array[kept] = std::move(array[slot]);
    ++kept;
  }
  array.erase(array.begin() + static_cast<std::ptrdiff_t>(kept), array.end());
}

/// Takes the entries of several groups of slots, each in ascending order, out of an array; those behind move up.
/// @return The entries, group by group.
template <class T>
std::vector<std::vector<T>> takeSlots(std::vector<T>& array, const std::vector<std::vector<Slot>>& groups) {
  std::vector<std::vector<T>> taken(groups.size());
  std::vector<Slot> all;
  for (std::size_t group = 0; group < groups.size(); ++group) {
    for (const Slot slot : groups[group]) taken[group].push_back(std::move(array[slot]));
    all.insert(all.end(), groups[group].begin(), groups[group].end());
  }
  std::sort(all.begin(), all.end());
  eraseSlots(array, all);
  return taken;
}

/// Puts groups of entries into an array, so that they have these slots then; the others make room.
template <class T>
void giveSlots(std::vector<T>& array, const std::vector<std::vector<Slot>>& groups,
               std::vector<std::vector<T>>& entries) {
  std::vector<std::pair<Slot, T*>> given;
  for (std::size_t group = 0; group < groups.size(); ++group) {
    for (std::size_t i = 0; i < groups[group].size(); ++i) given.emplace_back(groups[group][i], &entries[group][i]);
  }
  std::sort(given.begin(), given.end());
  const std::size_t count = array.size() + given.size();
  std::vector<T> result;
  result.reserve(count);
  auto next = given.begin();
  auto own = array.begin();
  while (result.size() < count) {
    const bool isGiven = next != given.end() && next->first == result.size();
    result.push_back(std::move(isGiven ? *(next++)->second : *own++));
  }
  array = std::move(result);
}

/// The entities of a world, by kind, each kind in the order of its ids. A slot in them is a place in these arrays.
struct Records {
  std::vector<ModelRecord> models;
  std::vector<LinkRecord> links;
  std::vector<JointRecord> joints;
  std::vector<CollisionRecord> collisions;
  std::vector<SensorRecord> sensors;
  std::vector<LightRecord> lights;
  std::vector<ActorRecord> actors;
};

/// What stands at the world's level, by its slots.
struct Roots {
  std::vector<Slot> models;
  std::vector<Slot> lights;
  std::vector<Slot> actors;
};

/// Which slots groups of entities have had or have now, group by group, each in ascending order.
struct GroupSlots {
  std::vector<std::vector<Slot>> links;
  std::vector<std::vector<Slot>> joints;
};

/// Groups of entities that are set aside, and the slots that they had.
struct Departure {
  std::vector<Records> groups;
  GroupSlots slots;
};

/// Who is there: the models, links and joints of a world with their ids, names and places in the arrays. Made from
/// a description, which must outlive it.
///
/// Ids follow the order of the file: the world is 1; then each model, its links (each followed by as many ids as it
/// has visuals, by its collisions, its lights and its sensors), the models in it and its joints (each followed by its
/// sensors); last the world's own joints, its lights, and its actors, each followed by as many ids as its links have
/// visuals. All of a kind have their slots in the order of their ids: what comes later takes the last ones, where
/// something goes, those behind it move up, and what comes back after it was set aside has its place again.
class Entities {
 public:
  /// @throws std::invalid_argument if a joint or a model names a link that isn't there.
  explicit Entities(const description::World& world);

  const description::World& description() const { return *description_; }
  WorldId worldId() const { return worldId_; }

  const std::vector<ModelRecord>& models() const { return models_; }
  const std::vector<LinkRecord>& links() const { return links_; }
  const std::vector<JointRecord>& joints() const { return joints_; }
  const std::vector<CollisionRecord>& collisions() const { return collisions_; }
  const std::vector<SensorRecord>& sensors() const { return sensors_; }
  const std::vector<LightRecord>& lights() const { return lights_; }
  const std::vector<ActorRecord>& actors() const { return actors_; }
  /// Slots of the models at the top level, in the order of the file.
  const std::vector<Slot>& topLevelModels() const { return topLevelModels_; }

  /// @return The slot, or `kNoSlot` if there is no such entity (any more).
  Slot slot(ModelId id) const;
  Slot slot(LinkId id) const;
  Slot slot(JointId id) const;
  Slot slot(CollisionId id) const;
  Slot slot(SensorId id) const;
  Slot slot(LightId id) const;

  /// @param scopedName "outer::inner"
  Slot findModel(std::string_view scopedName) const;
  /// @param model `kNoSlot`: the world itself.
  /// @return What stands in front of the topics of its systems and sensors; mostly empty.
  const std::string& nameSpace(Slot model) const;
  /// @param name Link as the model sees it: "link" or "inner::link"; where `model` is `kNoSlot`, as the world does.
  Slot findLink(Slot model, std::string_view name) const;
  /// @param name Joint as the model sees it, likewise.
  Slot findJoint(Slot model, std::string_view name) const;
  /// @param name Link as the world sees it: "model::link".
  Slot findLink(std::string_view name) const;

  /// @param link That holds it; `kNoSlot` for a light of the world.
  Slot findLight(Slot link, std::string_view name) const;

  /// Adds a model at the top level, with the links, models and joints in it.
  /// @param model Its name must be free.
  /// @throws std::invalid_argument as the constructor does; nothing is added then.
  /// @return Its slot.
  Slot insertModel(std::shared_ptr<const description::Model> model);

  /// Adds a joint of the world itself, between links as the world names them.
  /// @param id That it had when a state was saved; nothing: a new one.
  /// @throws std::invalid_argument as the constructor does; nothing is added then.
  Slot insertJoint(std::shared_ptr<const description::Joint> joint, std::optional<JointId> id = std::nullopt);

  /// Removes a model of the top level with all that is in it, and the joints that hold on to its links.
  Removal removeModel(Slot model);
  Removal removeJoint(Slot joint);

  /// Adds a light of the world.
  /// @param light Its name must be free.
  Slot insertLight(std::shared_ptr<const description::Light> light);
  /// Lets a light be what this one is. It keeps its id and what holds it.
  void changeLight(Slot light, std::shared_ptr<const description::Light> changed);
  void removeLight(Slot light);

  /// Takes groups of entities out, with their ids and with the joints that hold on to their links. A joint must not
  /// hold a group to what is not of it.
  Departure setAside(const std::vector<Roots>& groups);
  /// Puts groups back that were set aside.
  /// @return The slots that they have now.
  GroupSlots bringBack(std::vector<Records> groups);

  /// Back to what the description says. Who is in it has the ids of the start again; no other id is used a second time.
  void reset();

  /// Sets the pose of a model that has no link.
  void setPose(Slot model, const Pose& X_WorldModel) { models_[model].X_CanonicalModel = X_WorldModel; }

  /// @return The links of a model and of those nested in it.
  std::vector<Slot> allLinks(Slot model) const;

  /// @return An id that nothing has had in this run.
  std::uint64_t nextId() { return ++lastId_; }

 private:
  void addAll();
  Slot addModel(const description::Model& description, Slot parent, const Pose& X_WorldParent);
  void addLinks(Slot model, const Pose& X_WorldModel);
  void addJoint(const description::Joint& description, Slot model, std::optional<JointId> id = std::nullopt);
  void addSensors(const std::vector<description::Sensor>& sensors, Slot link, Slot joint);
  void addLights(const std::vector<description::Light>& lights, Slot link);
  void collectModels(Slot model, std::vector<Slot>& models) const;
  void remove(const std::vector<Slot>& models, const Removal& removal);
  void renumber(const std::vector<Slot>& models, const Removal& removal);
  void index();
  /// Takes the records of these slots, in ascending order, out, and tells the index of those that move up.
  template <class Record>
  void erase(std::vector<Record>& records, const std::vector<Slot>& slots);
  Records takeRecords();
  void giveRecords(Records records);

  const description::World* description_;
  std::uint64_t lastId_ = 0;
  WorldId worldId_;
  std::vector<ModelRecord> models_;
  std::vector<LinkRecord> links_;
  std::vector<JointRecord> joints_;
  std::vector<CollisionRecord> collisions_;
  std::vector<SensorRecord> sensors_;
  std::vector<LightRecord> lights_;
  std::vector<ActorRecord> actors_;
  std::vector<Slot> topLevelModels_;
  IdIndex slotOfId_;
  /// The id, which stays where slots change.
  std::unordered_map<std::string, ModelId> modelOfName_;
};

}  // namespace pongsim::world
