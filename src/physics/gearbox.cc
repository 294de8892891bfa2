#include "physics/gearbox.hh"

#include <LinearMath/btQuaternion.h>

#include <cmath>
#include <numbers>

#include "pongsim/math.hh"

namespace pongsim::physics {

namespace {

// in the constraint's user type, by which it is known again
constexpr int kGearReference = 1;

}  // namespace

GearReference::GearReference(btRigidBody& reference, btRigidBody& other)
    : btTypedConstraint(MAX_CONSTRAINT_TYPE, reference, other) {
  setUserConstraintType(kGearReference);
}

void GearReference::getInfo1(btConstraintInfo1* info) {
  info->m_numConstraintRows = 1;
  info->nub = 0;
}

void GearReference::getInfo2(btConstraintInfo2* info) {
  for (int i = 0; i < 3; ++i) info->m_J1angularAxis[i] = torque_[i];
  info->m_constraintError[0] = 0;
  info->m_lowerLimit[0] = -SIMD_INFINITY;
  info->m_upperLimit[0] = SIMD_INFINITY;
}

bool isGearReference(const btTypedConstraint& joint) { return joint.getUserConstraintType() == kGearReference; }

double turnAbout(const btVector3& axis, const btMatrix3x3& R_WorldReference, const btMatrix3x3& R_WorldGear) {
  btQuaternion turn;
  (R_WorldReference.transpose() * R_WorldGear).getRotation(turn);
  const double sine = btVector3(turn.x(), turn.y(), turn.z()).dot(axis);
  return std::remainder(2 * math::atan2(sine, turn.w()), 2 * std::numbers::pi);
}

}  // namespace pongsim::physics
