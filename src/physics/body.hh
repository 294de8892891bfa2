#pragma once

#include "physics/convert.hh"
#include "physics/mass.hh"
#include "physics/rigid_body.hh"
#include "physics/shapes/shape.hh"
#include "pongsim/state/state_archive.hh"
#include "pongsim/types.hh"
#include "world/entities.hh"
#include "world/state.hh"

namespace pongsim::physics {

/// @return Whether forces move the link: it is neither static nor kinematic.
inline bool isMoving(const world::LinkRecord& link) { return !link.isStatic && !link.description->kinematic; }

/// A link as a rigid body. Bullet's body frame is at the centre of mass, along the principal axes of inertia.
class Body {
 public:
  /// @param gravity World frame [m/s^2].
  /// @throws std::invalid_argument if a moving link's mass or inertia is impossible.
  Body(const world::Entities& entities, world::Slot link, const Vector3& gravity, HullStore& hulls,
       SharedShapes& shared);
  Body(const Body&) = delete;
  Body& operator=(const Body&) = delete;

  btRigidBody& rigid() { return rigid_; }
  const btRigidBody& rigid() const { return rigid_; }
  world::Slot link() const { return link_; }
  /// Id of the link.
  LinkId id() const { return id_; }
  /// Call when the link gets another slot.
  void setLink(world::Slot link);
  bool moves() const { return moves_; }
  bool collides() const { return !shape_.empty(); }
  LinkShape& shape() { return shape_; }
  const LinkShape& shape() const { return shape_; }
  /// Pose of the body frame in the link frame.
  const Pose& X_LinkBody() const { return X_LinkBody_; }

  /// Mass [kg], and how many times the description's moments of inertia the present ones are: along all principal axes,
  /// and beyond that along each.
  struct Mass {
    double mass = 0;
    double inertiaFactor = 1;
    Vector3 stretch = Vector3::Ones();
    bool operator==(const Mass&) const = default;
  };
  const Mass& mass() const { return mass_; }
  /// @return False where its added mass does not allow this mass: there are motions whose inertia would be negative.
  bool canHave(const Mass& mass) const;
  /// @return The principal moments of inertia of the description [kg m^2].
  Vector3 momentsOfFile() const { return fromBullet(momentsOfFile_); }
  /// The centre of mass and the principal axes stay. All numbers must be positive, and possible.
  void setMass(const Mass& mass);

  /// Takes the sizes of the link's shapes, which have changed. The caller discards its contacts.
  void reshape(const description::Link& description, HullStore& hulls, SharedShapes& shared);

  /// @param gravity World frame [m/s^2]; has no effect on a link with gravity switched off.
  void setGravity(const Vector3& gravity);

  /// Sets the pose of the link. Its velocity stays.
  void setPose(const Pose& X_WorldLink);

  /// Adds gravity and the gyroscopic torque for the next step of `dt` [s], and updates the inertia for it.
  /// @param isHeld Whether joints constrain its motion.
  void addForces(double dt, bool isHeld);

  /// Adds a force at the link frame's origin and a torque for the next step, world frame [N, N m].
  void addWrench(const Vector3& force, const Vector3& torque);

  /// Sets the velocity of the link frame's origin [m/s] and the angular velocity [rad/s], world frame.
  void setVelocity(const Vector3& linear, const Vector3& angular);

  /// Saves or restores everything that it keeps from step to step.
  void transfer(StateArchive& archive);

  /// Limits its rotation to one turn in a step of `dt` [s]: faster rotation can't be resolved, and errors would speed
  /// it up further. Limits its speed to 1e6 m/s, so that absurd forces do not end a run.
  /// @return Whether a limit applied.
  bool slowDown(double dt);

  /// Writes the link's pose and velocity.
  /// @return Whether all values are finite and within reason.
  bool read(world::LinkState& state) const;

 private:
  Body(const world::LinkRecord& record, world::Slot link, const PrincipalMass& mass, const Vector3& gravity,
       HullStore& hulls, SharedShapes& shared);

  world::Slot link_;
  LinkId id_;
  bool moves_;
  bool hasGravity_;
  Mass mass_;
  /// Principal moments of inertia of the description and now [kg m^2], and whether they are all the same.
  const btVector3 momentsOfFile_;
  btVector3 moments_;
  bool isRound_;
  Pose X_LinkBody_;
  Pose X_BodyLink_;
  /// Whether the link frame's origin is the centre of mass.
  bool isCentred_;
  LinkShape shape_;
  RigidBody rigid_;
};

}  // namespace pongsim::physics
