#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "description/joint.hh"
#include "description/model.hh"
#include "pongsim/handles.hh"
#include "sim/api/access.hh"

namespace pongsim::sim {

/// Changes a world's entities, state and engine consistently, between two steps. A refused change has no effect.
class Editor {
 public:
  explicit Editor(Access& access) : access_(access) {}

  /// @return `name` if no model or light at the top level has it, else the first free one of `name`_0, `name`_1 and so
  /// on, as in Fortress.
  std::string freeName(const std::string& name) const;
  bool isFree(std::string_view name) const;

  /// @param model With a free name.
  /// @throws std::invalid_argument if it can't be simulated; then nothing is changed.
  /// @return Its slot.
  world::Slot insert(std::shared_ptr<const description::Model> model);

  /// @param models At the top level, in ascending order.
  /// @return The removed models, nested ones too, in ascending order.
  std::vector<ModelId> remove(const std::vector<world::Slot>& models);

  Outcome<void> setPose(world::Slot model, const Pose& X_WorldModel, AfterMove after);
  Outcome<void> setLinkPose(world::Slot link, const Pose& X_WorldLink, AfterMove after);
  /// Sets the velocity of the link frame's origin in the world frame, as in `Link::setVelocity`. No effect on a link
  /// that does not move.
  void setLinkVelocity(world::Slot link, const Vector3& linear, const Vector3& angular);

  /// Moves links like a rigid body, ignoring joints.
  void move(const std::vector<world::Slot>& links, const Pose& X_NewOld, AfterMove after);

  /// Connects two links by a fixed joint that belongs to the world, and keeps their current poses.
  /// @param name Empty: chosen automatically.
  world::Slot attach(world::Slot parent, world::Slot child, std::string name);
  void detach(world::Slot joint);
  /// Adds a joint that belongs to the world.
  /// @param id As in `Entities::insertJoint`.
  world::Slot insertJoint(std::shared_ptr<const description::Joint> joint, std::optional<JointId> id = std::nullopt);

  void setGravity(const Vector3& gravity);

  /// Sets the entities with these ids aside, and returns all others to the world; see `Entities::setAside`.
  void setAside(const std::vector<std::uint64_t>& ids);

  /// Resets to the start.
  void reset();

  /// Cancels the commands to joints of models whose batteries are empty.
  void cutPower();

 private:
  /// @return A joint that connects some of these links, in ascending order, to another link; null if there is none.
  const world::JointRecord* holder(const std::vector<world::Slot>& links) const;
  /// To be called after each change of the entities.
  void noteChange();
  /// Calls `insert`, which adds to the entities, and then extends state and engine. If anything throws, all is undone.
  template <class Insert>
  world::Slot insertAllOrNothing(Insert insert);
  Access& access_;
};

/// @return What is wrong with a requested pose, to follow its name: "is not finite"; null if it is valid.
const char* poseFault(const Pose& pose);

}  // namespace pongsim::sim
