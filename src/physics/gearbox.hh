#pragma once

#include <BulletDynamics/ConstraintSolver/btTypedConstraint.h>

#include <array>

namespace pongsim::physics {

/// What a gearbox's one row does to a third body, the one that its axes are fixed to, as a row for Bullet's solver,
/// which knows rows of two bodies only. It must follow the row of the two gears in the solver's list; `ContactSolver`
/// makes one of the two.
class GearReference final : public btTypedConstraint {
 public:
  /// @param other A body that moves and that the gearbox acts on, too, so that the two come into one group.
  GearReference(btRigidBody& reference, btRigidBody& other);

  /// Sets what a unit of the row's impulse does to the reference body [N m s], world frame.
  void setTorque(const btVector3& torque) { torque_ = torque; }

  void getInfo1(btConstraintInfo1* info) override;
  void getInfo2(btConstraintInfo2* info) override;
  void setParam(int, btScalar, int) override {}
  btScalar getParam(int, int) const override { return 0; }

 private:
  btVector3 torque_{0, 0, 0};
};

/// @return Whether it is a `GearReference`.
bool isGearReference(const btTypedConstraint& joint);

/// @return How far a frame has turned about a unit vector of it, seen from another one that it lay along at the start
/// [rad], between -pi and pi. What it has turned otherwise does not count.
/// @param axis In either frame, at the start.
double turnAbout(const btVector3& axis, const btMatrix3x3& R_WorldReference, const btMatrix3x3& R_WorldGear);

}  // namespace pongsim::physics
