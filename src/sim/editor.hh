#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "description/joint.hh"
#include "description/model.hh"
#include "pongsim/handles.hh"
#include "sim/access.hh"

namespace pongsim::sim {

/// Changes who is in a world and where, between two steps: entities, state and engine together. What is refused
/// changes nothing.
class Editor {
 public:
  explicit Editor(Access& access) : access_(access) {}

  /// @return `name` if no model or light at the top level has it, else the first of `name`_0, `name`_1 and so on that
  /// is free, as in Fortress.
  std::string freeName(const std::string& name) const;
  bool isFree(std::string_view name) const;

  /// @param model Its name must be free.
  /// @throws std::invalid_argument if it can't be simulated; nothing is changed then.
  /// @return Its slot.
  world::Slot insert(std::shared_ptr<const description::Model> model);

  /// @param model At the top level.
  /// @return Who has gone: the model and those nested in it.
  std::vector<ModelId> remove(world::Slot model);

  /// @return Why not, or nothing.
  std::optional<std::string> setPose(world::Slot model, const Pose& X_WorldModel, AfterMove after);
  std::optional<std::string> setLinkPose(world::Slot link, const Pose& X_WorldLink, AfterMove after);

  /// Moves links as if they were one body. Joints are not looked at.
  void move(const std::vector<world::Slot>& links, const Pose& X_NewOld, AfterMove after);

  /// Makes a fixed joint of the world itself that holds the child to the parent as they are.
  /// @param name Empty: one that is free.
  world::Slot attach(world::Slot parent, world::Slot child, std::string name);
  void detach(world::Slot joint);
  /// Adds a joint of the world itself.
  /// @param id As `Entities::insertJoint` has it.
  world::Slot insertJoint(std::shared_ptr<const description::Joint> joint, std::optional<JointId> id = std::nullopt);

  void setGravity(const Vector3& gravity);

  /// Sets groups of entities aside, each to come back as one. A joint must not hold one to what is not of it.
  void setAside(const std::vector<world::Roots>& groups);
  /// Brings those of these places in the shelf back, in ascending order.
  void bringBack(const std::vector<std::size_t>& places);

  /// Back to the start.
  void reset();

  /// Takes back what is asked of the joints of models whose batteries are empty.
  void cutPower();

 private:
  /// @return The joint that holds some of these links, in ascending order, to something else; null if there is none.
  const world::JointRecord* holder(const std::vector<world::Slot>& links) const;
  void putShelfInOrder();
  Access& access_;
};

/// @return Whether all of it is finite and its rotation not zero.
bool isSound(const Pose& pose);

}  // namespace pongsim::sim
