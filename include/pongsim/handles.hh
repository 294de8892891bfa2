#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pongsim/export.hh"
#include "pongsim/types.hh"

namespace pongsim {

namespace sim {
class Access;
class SystemSet;
}  // namespace sim

/// A way to one link of a running world. A copy is the same link; it must not outlive its `Simulation`.
class PONGSIM_API Link {
 public:
  LinkId id() const { return id_; }
  /// @return Its name in the model.
  std::string_view name() const;
  /// @return Pose of the link frame in the world frame.
  Pose pose() const;
  /// @return Velocity of the link frame's origin, world frame [m/s].
  Vector3 linearVelocity() const;
  /// @return Angular velocity, world frame [rad/s].
  Vector3 angularVelocity() const;
  /// Applies a force at the link frame's origin and a torque during the next step, both in the world frame
  /// [N, N m]. Several calls add up.
  void addWrench(const Vector3& force, const Vector3& torque);

 private:
  friend class Model;
  Link(sim::Access& access, LinkId id) : access_(&access), id_(id) {}
  sim::Access* access_;
  LinkId id_;
};

/// A way to one joint of a running world. A copy is the same joint; it must not outlive its `Simulation`.
class PONGSIM_API Joint {
 public:
  JointId id() const { return id_; }
  /// @return Its name in the model.
  std::string_view name() const;
  /// @return Number of axes that have a position: 0 (fixed, ball) or 1 (revolute, prismatic).
  int axisCount() const;
  /// @return Position of the axis since the start: angle [rad], not wrapped, or travel [m].
  double position(int axis = 0) const;
  /// @return Velocity of the axis [rad/s or m/s].
  double velocity(int axis = 0) const;
  /// Drives the axis at that velocity [rad/s or m/s] from the next step on, as far as its effort limit allows,
  /// until another command comes; 0 brakes. A value that is not finite is refused with a warning.
  void setVelocityTarget(double velocity, int axis = 0);
  /// Applies a force along the axis [N m or N] during the next step. Several calls add up. A value that is not
  /// finite is refused with a warning.
  void addForce(double force, int axis = 0);

 private:
  friend class Model;
  Joint(sim::Access& access, JointId id) : access_(&access), id_(id) {}
  sim::Access* access_;
  JointId id_;
};

/// A way to one model of a running world. A copy is the same model; it must not outlive its `Simulation`.
class PONGSIM_API Model {
 public:
  ModelId id() const { return id_; }
  /// @return Its own name, without the models it is nested in.
  std::string_view name() const;
  /// @return Its name with the models it is nested in: "outer::inner".
  std::string scopedName() const;
  /// @return Pose of the model frame in the world frame.
  Pose pose() const;
  bool isStatic() const;
  /// @return The link that the model frame moves with; nothing for a model without links.
  std::optional<Link> canonicalLink() const;
  std::vector<Link> links() const;
  std::vector<Joint> joints() const;
  /// @param name Name in this model, or with nested models: "inner::wheel".
  std::optional<Link> link(std::string_view name) const;
  std::optional<Joint> joint(std::string_view name) const;
  std::vector<Model> models() const;

 private:
  friend class World;
  friend class sim::SystemSet;
  Model(sim::Access& access, ModelId id) : access_(&access), id_(id) {}
  sim::Access* access_;
  ModelId id_;
};

/// A way to a running world. It must not outlive its `Simulation`.
class PONGSIM_API World {
 public:
  explicit World(sim::Access& access) : access_(&access) {}
  std::string_view name() const;
  WorldId id() const;
  /// @return Gravity in the world frame [m/s^2].
  Vector3 gravity() const;
  /// @return The models at the top level, in the order of the file.
  std::vector<Model> models() const;
  /// @param name A model's name, nested ones as "outer::inner".
  std::optional<Model> model(std::string_view name) const;

 private:
  sim::Access* access_;
};

}  // namespace pongsim
