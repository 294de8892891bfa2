#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <ranges>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "description/world.hh"
#include "pongsim/types.hh"
#include "world/id_index.hh"

namespace pongsim::world {

/// Index of a link, joint or model in the arrays of `Entities` and `State`.
using Slot = std::size_t;
/// Stands for no slot, or for the world itself.
inline constexpr Slot kNoSlot = std::numeric_limits<Slot>::max();

struct LinkRecord {
  LinkId id;
  const description::Link* description = nullptr;
  Slot model = kNoSlot;
  /// Whether its model, or a parent of it, is static.
  bool isStatic = false;
  /// Pose of the link frame in the world frame at the start.
  Pose X_WorldLinkStart;
  /// Slot of its first collision, followed by the others.
  Slot firstCollision = 0;
  bool isSetAside = false;
  /// Owns the description of a link whose shapes have other sizes than in the file, and that of the file.
  std::shared_ptr<const description::Link> changed = nullptr;
  const description::Link* ofFile = nullptr;
};

struct JointRecord {
  JointId id;
  /// Owns the description of a joint made at run time.
  std::shared_ptr<const description::Joint> owner = nullptr;
  const description::Joint* description = nullptr;
  /// `kNoSlot` for a joint of the world.
  Slot model = kNoSlot;
  /// `kNoSlot` stands for the world.
  Slot parentLink = kNoSlot;
  Slot childLink = kNoSlot;
  /// For a gearbox: the link to which its axes are fixed.
  Slot referenceLink = kNoSlot;
  bool isSetAside = false;
};

struct CollisionRecord {
  CollisionId id;
  const description::Collision* description = nullptr;
  Slot link = kNoSlot;
  bool isSetAside = false;
};

struct SensorRecord {
  SensorId id;
  const description::Sensor* description = nullptr;
  /// Its parent; the other one is `kNoSlot`.
  Slot link = kNoSlot;
  Slot joint = kNoSlot;
  bool isSetAside = false;
};

struct LightRecord {
  LightId id;
  /// Owns the description of a light inserted or changed at run time.
  std::shared_ptr<const description::Light> owner = nullptr;
  const description::Light* description = nullptr;
  /// Its parent; `kNoSlot` for a light of the world.
  Slot link = kNoSlot;
  bool isSetAside = false;
};

struct ActorRecord {
  ActorId id;
  const description::Actor* description = nullptr;
  bool isSetAside = false;
};

/// @return The id of a visual of the actor's links.
inline VisualId visualId(const ActorRecord& actor, std::size_t visual) { return VisualId{actor.id.value + 1 + visual}; }

struct ModelRecord {
  ModelId id;
  /// The largest id of its parts, whose ids follow its own.
  std::uint64_t lastId = 0;
  /// Owns the description of a model inserted at run time; unset for models nested in it.
  std::shared_ptr<const description::Model> owner = nullptr;
  const description::Model* description = nullptr;
  /// `kNoSlot` for a model at the top level.
  Slot parent = kNoSlot;
  /// "outer::inner"
  std::string scopedName;
  bool isStatic = false;
  /// `kNoSlot` for a model without links, which does not move.
  Slot canonicalLink = kNoSlot;
  /// Pose of the model frame in the frame of its canonical link, or in the world without one; constant.
  Pose X_CanonicalModel;
  std::vector<Slot> links;
  std::vector<Slot> joints;
  std::vector<Slot> models;
  bool isSetAside = false;
};

/// @return The id of a visual of the link.
inline VisualId visualId(const LinkRecord& link, std::size_t visual) { return VisualId{link.id.value + 1 + visual}; }

/// Removed entities: their former slots and their ids, in ascending order. Keeps their descriptions alive.
struct Removal {
  std::vector<Slot> links;
  std::vector<Slot> joints;
  std::vector<ModelId> models;
  std::vector<std::shared_ptr<const void>> descriptions;
};

/// Removes the entries at these slots, in ascending order, from an array; those behind move up.
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

/// @return The records of a kind that are not set aside.
template <class Record>
auto present(const std::vector<Record>& records) {
  return records | std::views::filter([](const Record& record) { return !record.isSetAside; });
}

/// The entities of a world: its models, links and joints with their ids, names and slots. Made from a description,
/// which must outlive it.
///
/// Ids follow the order of the file: the world is 1; then each model, its links (each followed by as many ids as it has
/// visuals, by its collisions, its lights and its sensors), its nested models and its joints (each followed by its
/// sensors); finally the world's own joints, its lights, and its actors, each followed by as many ids as its links have
/// visuals. Slots of a kind are in the order of ids: new entities get the last ones, and removing one moves up those
/// behind it.
///
/// Entities that are set aside keep their records and slots, but lookups by id or name do not find them. Whoever goes
/// through an array skips them (`present`).
class Entities {
 public:
  /// @throws std::invalid_argument if a joint or model names a link that does not exist.
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
  /// Slots of the top-level models that are not set aside, in the order of the file.
  const std::vector<Slot>& topLevelModels() const { return topLevelModels_; }

  /// @return The slot, or `kNoSlot` if the entity does not exist (any more) or is set aside.
  Slot slot(ModelId id) const;
  Slot slot(LinkId id) const;
  Slot slot(JointId id) const;
  Slot slot(CollisionId id) const;
  Slot slot(SensorId id) const;
  Slot slot(LightId id) const;

  /// @param scopedName "outer::inner"
  Slot findModel(std::string_view scopedName) const;
  /// @param model `kNoSlot`: the world.
  /// @return The prefix of the topics of its systems and sensors; usually empty.
  const std::string& nameSpace(Slot model) const;
  /// @param name Name of the link in the model: "link" or "inner::link"; with `kNoSlot` in the world.
  Slot findLink(Slot model, std::string_view name) const;
  /// @param name Name of the joint in the model, likewise.
  Slot findJoint(Slot model, std::string_view name) const;
  /// @param name Name of the link in the world: "model::link".
  Slot findLink(std::string_view name) const;

  /// @param link Its parent; `kNoSlot` for a light of the world.
  Slot findLight(Slot link, std::string_view name) const;

  /// Adds a top-level model with its links, nested models and joints.
  /// @param model With a free name.
  /// @throws std::invalid_argument like the constructor; then nothing is added.
  /// @return Its slot.
  Slot insertModel(std::shared_ptr<const description::Model> model);

  /// Adds a joint of the world, between links named as in the world.
  /// @param id Its id in a saved state; unset: a new one.
  /// @throws std::invalid_argument like the constructor; then nothing is added.
  Slot insertJoint(std::shared_ptr<const description::Joint> joint, std::optional<JointId> id = std::nullopt);

  /// Removes top-level models with all their parts, and joints connected to their links.
  /// @param models In ascending order. However many, all records behind the first one move up only once.
  Removal removeModels(const std::vector<Slot>& models);
  Removal removeModel(Slot model) { return removeModels({model}); }
  Removal removeJoint(Slot joint);

  /// Adds a light to the world.
  /// @param light With a free name.
  Slot insertLight(std::shared_ptr<const description::Light> light);
  /// Replaces a light's description. It keeps its id and parent.
  void changeLight(Slot light, std::shared_ptr<const description::Light> changed);
  void removeLight(Slot light);

  /// Replaces a link's description by one that differs in the sizes of its shapes only. The link, its collisions and
  /// visuals keep their ids.
  /// @param changed Null: that of the file again.
  void changeLink(Slot link, std::shared_ptr<const description::Link> changed);

  /// What a call of `setAside` has changed.
  struct Switched {
    bool isAny = false;
    /// Links, in ascending order.
    std::vector<Slot> setAside;
    std::vector<Slot> returned;
  };
  /// Sets entities aside with all their parts, and returns all others. No joint may connect one that is set aside to
  /// one that is not.
  /// @param ids Of top-level models, lights of the world and actors, in ascending order; others are ignored.
  Switched setAside(const std::vector<std::uint64_t>& ids);
  /// @return The ids with which `setAside` was called, without those ignored or removed since.
  std::vector<std::uint64_t> listSetAside() const;
  /// @return Whether a model, link, joint, collision, sensor or actor is set aside.
  bool isSetAside(std::uint64_t id) const;
  /// @return Whether a model of this scoped name is set aside.
  bool isSetAside(std::string_view scopedName) const;
  /// @return Whether a model, or a light of the world, has this name, even if it is set aside.
  bool isTaken(std::string_view name) const;

  /// How much there is, to undo insertions.
  struct Extent {
    std::size_t models, links, joints, collisions, sensors, lights, worldJoints, topLevelModels;
    std::uint64_t lastId;
  };
  Extent extent() const;
  /// Removes what was inserted since. Nothing else may have been changed.
  void undoInsertions(const Extent& before) noexcept;

  /// Resets to the description. Its entities have the same ids as at the start; other ids are never reused.
  void reset();

  /// Sets the pose of a model without links.
  void setPose(Slot model, const Pose& X_WorldModel) { models_[model].X_CanonicalModel = X_WorldModel; }

  /// @return The joints of the link's top-level model and of all its nested models.
  std::span<const JointRecord> jointsAround(Slot link) const;
  /// @return The joints of the world itself, which may connect any links, even if they are set aside.
  const std::vector<JointId>& worldJoints() const { return worldJoints_; }

  /// @return The links of a model and of its nested models.
  std::vector<Slot> allLinks(Slot model) const;

  /// @return Whether ids are in order, slots are in range, and parts are set aside like what they are part of.
  bool isConsistent() const;

  /// @return A number that changes when names may have become free.
  std::uint64_t removals() const { return removals_; }

  /// @return A new id, unused in this run.
  std::uint64_t nextId() { return ++lastId_; }

 private:
  void addAll();
  Slot addModel(const description::Model& description, Slot parent, const Pose& X_WorldParent);
  void addLinks(Slot model, const Pose& X_WorldModel);
  void addJoint(const description::Joint& description, Slot model, std::optional<JointId> id = std::nullopt);
  void addSensors(const std::vector<description::Sensor>& sensors, Slot link, Slot joint);
  void addLights(const std::vector<description::Light>& lights, Slot link);
  void addLight(const description::Light& light, Slot link);
  void collectModels(Slot model, std::vector<Slot>& models) const;
  /// Slots of each kind to remove, in ascending order.
  struct Gone {
    std::vector<Slot> models, links, joints, collisions, sensors, lights;
  };
  /// @param from No record with a smaller id refers to a slot that is removed or moves up, except joints of the world.
  void remove(const Gone& gone, std::uint64_t from);
  void renumber(const Gone& gone, std::uint64_t from);
  void renumberJoint(JointRecord& joint, const Gone& gone);
  /// Removes the records at these slots, in ascending order, and updates the index of those that move up.
  template <class Record>
  void erase(std::vector<Record>& records, const std::vector<Slot>& slots);
  template <class Add>
  void addAllOrNothing(Add add);

  const description::World* description_;
  std::uint64_t lastId_ = 0;
  std::uint64_t removals_ = 0;
  WorldId worldId_;
  std::vector<ModelRecord> models_;
  std::vector<LinkRecord> links_;
  std::vector<JointRecord> joints_;
  std::vector<CollisionRecord> collisions_;
  std::vector<SensorRecord> sensors_;
  std::vector<LightRecord> lights_;
  std::vector<ActorRecord> actors_;
  std::vector<Slot> topLevelModels_;
  std::vector<JointId> worldJoints_;
  IdIndex slotOfId_;
  /// By id, which stays the same when slots change.
  std::unordered_map<std::string, ModelId> modelOfName_;
};

}  // namespace pongsim::world
