#pragma once

#include <BulletDynamics/ConstraintSolver/btTypedConstraint.h>

#include <array>

namespace pongsim::physics {

/// The effect of a gearbox's single row on a third body, the one that its axes are fixed to. Bullet's solver only has
/// rows of two bodies, so this is a row of its own. It must follow the row of the two gears in the solver's list;
/// `ContactSolver` combines the two.
class GearReference final : public btTypedConstraint {
 public:
  /// @param other A moving body that the gearbox also acts on, so that the two are in the same island.
  GearReference(btRigidBody& reference, btRigidBody& other);

  /// Sets the effect of a unit impulse of the row on the reference body [N m s], world frame.
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

/// @return The rotation of a frame about one of its unit vectors, relative to a reference frame that it was aligned
/// with at the start [rad], between -pi and pi. Rotation about other axes does not count.
/// @param axis In either frame, at the start.
double turnAbout(const btVector3& axis, const btMatrix3x3& R_WorldReference, const btMatrix3x3& R_WorldGear);

}  // namespace pongsim::physics
