#include "physics/contact_solver.hh"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>
#include <cstdint>

#include "physics/friction.hh"
#include "physics/gearbox.hh"

namespace pongsim::physics {

void ContactSolver::convertContacts(btPersistentManifold** manifolds, int count, const btContactSolverInfo& info) {
  frictions_.clear();
  for (int i = 0; i < count; ++i) orient(*manifolds[i]);
  btSequentialImpulseConstraintSolver::convertContacts(manifolds, count, info);
  for (int i = 0; i < m_tmpSolverContactConstraintPool.size(); ++i) {
    btSolverConstraint& row = m_tmpSolverContactConstraintPool[i];
    auto* point = static_cast<btManifoldPoint*>(row.m_originalContactPoint);
    if (point->m_combinedRestitution > 0 && point->getDistance() > 0) settleBounce(row, *point, info);
    // no pointer, but the number of its friction and one
    const auto number = reinterpret_cast<std::uintptr_t>(point->m_userPersistentData);
    if (number == 0) continue;
    point->m_userPersistentData = nullptr;
    const Friction& friction = frictions_[number - 1];
    btSolverConstraint& first = m_tmpSolverContactFrictionConstraintPool[row.m_frictionIndex];
    btSolverConstraint& second = m_tmpSolverContactFrictionConstraintPool[row.m_frictionIndex + 1];
    second.m_friction = friction.mu2;
    addSlip(first, friction.slip1, info.m_timeStep);
    addSlip(second, friction.slip2, info.m_timeStep);
  }
}

// Bullet lets two bodies that will meet in this step come to where they just touch, and takes what that costs from the
// bounce. They bounce here with all of it, a little early, or not in this step at all.
void ContactSolver::settleBounce(btSolverConstraint& row, const btManifoldPoint& point,
                                 const btContactSolverInfo& info) const {
  const auto velocityAt = [&](int body, const btVector3& position) {
    const btRigidBody* rigid = m_tmpSolverBodyPool[body].m_originalBody;
    if (rigid == nullptr) return btVector3(0, 0, 0);
    return rigid->getVelocityInLocalPoint(position - rigid->getCenterOfMassPosition());
  };
  const btVector3 velocity = velocityAt(row.m_solverBodyIdA, point.getPositionWorldOnA()) -
                             velocityAt(row.m_solverBodyIdB, point.getPositionWorldOnB());
  const double approach = -point.m_normalWorldOnB.dot(velocity);
  if (approach < info.m_restitutionVelocityThreshold) return;
  const double gapRate = point.getDistance() / info.m_timeStep;
  const double change = gapRate < approach ? gapRate : -point.m_combinedRestitution * approach;
  row.m_rhs += change * row.m_jacDiagABInv;
}

void ContactSolver::convertJoints(btTypedConstraint** joints, int count, const btContactSolverInfo& info) {
  btSequentialImpulseConstraintSolver::convertJoints(joints, count, info);
  ties_.clear();
  btConstraintArray& rows = m_tmpSolverNonContactConstraintPool;
  for (int i = 1; i < rows.size(); ++i) {
    btSolverConstraint& second = rows[i];
    if (!isGearReference(*static_cast<const btTypedConstraint*>(second.m_originalContactPoint))) continue;
    btSolverConstraint& first = rows[i - 1];
    // an inverse of 0 is that of a row that moves nothing
    const auto stiffness = [](const btSolverConstraint& row) {
      return row.m_jacDiagABInv == 0 ? 0 : 1 / row.m_jacDiagABInv;
    };
    const double sum = stiffness(first) + stiffness(second);
    const double asked = first.m_rhs * stiffness(first) + second.m_rhs * stiffness(second);
    if (sum == 0) continue;
    first.m_jacDiagABInv = 1 / sum;
    first.m_rhs = asked / sum;
    // Bullet's own sweep leaves them alone
    first.m_overrideNumSolverIterations = second.m_overrideNumSolverIterations = 0;
    ties_.push_back(i - 1);
  }
}

btScalar ContactSolver::solveSingleIteration(int iteration, btCollisionObject** bodies, int bodyCount,
                                             btPersistentManifold** manifolds, int manifoldCount,
                                             btTypedConstraint** joints, int jointCount,
                                             const btContactSolverInfo& info, btIDebugDraw* debugDrawer) {
  double residual = 0;
  for (const int place : ties_) {
    btSolverConstraint& first = m_tmpSolverNonContactConstraintPool[place];
    btSolverConstraint& second = m_tmpSolverNonContactConstraintPool[place + 1];
    const double change = first.m_rhs - static_cast<double>(first.m_appliedImpulse) * first.m_cfm -
                          (velocityAlong(first) + velocityAlong(second)) * first.m_jacDiagABInv;
    applyImpulse(first, change);
    applyImpulse(second, change);
    const double missing = change / first.m_jacDiagABInv;
    residual = std::max(residual, missing * missing);
  }
  return std::max(residual,
                  btSequentialImpulseConstraintSolver::solveSingleIteration(
                      iteration, bodies, bodyCount, manifolds, manifoldCount, joints, jointCount, info, debugDrawer));
}

// what this step's impulses have added to it
double ContactSolver::velocityAlong(const btSolverConstraint& row) {
  btSolverBody& a = m_tmpSolverBodyPool[row.m_solverBodyIdA];
  btSolverBody& b = m_tmpSolverBodyPool[row.m_solverBodyIdB];
  return row.m_contactNormal1.dot(a.internalGetDeltaLinearVelocity()) +
         row.m_relpos1CrossNormal.dot(a.internalGetDeltaAngularVelocity()) +
         row.m_contactNormal2.dot(b.internalGetDeltaLinearVelocity()) +
         row.m_relpos2CrossNormal.dot(b.internalGetDeltaAngularVelocity());
}

void ContactSolver::applyImpulse(btSolverConstraint& row, double change) {
  btSolverBody& a = m_tmpSolverBodyPool[row.m_solverBodyIdA];
  btSolverBody& b = m_tmpSolverBodyPool[row.m_solverBodyIdB];
  row.m_appliedImpulse = static_cast<double>(row.m_appliedImpulse) + change;
  a.internalApplyImpulse(row.m_contactNormal1 * a.internalGetInvMass(), row.m_angularComponentA, change);
  b.internalApplyImpulse(row.m_contactNormal2 * b.internalGetInvMass(), row.m_angularComponentB, change);
}

// a velocity in proportion to the force: the row gives way by slip / dt of its impulse
void ContactSolver::addSlip(btSolverConstraint& row, double slip, double dt) {
  if (slip <= 0 || row.m_jacDiagABInv == 0) return;
  const double stiff = row.m_jacDiagABInv;
  row.m_jacDiagABInv = 1 / (1 / stiff + slip / dt);
  row.m_rhs *= row.m_jacDiagABInv / stiff;
  row.m_cfm = slip / dt * row.m_jacDiagABInv;
}

void ContactSolver::orient(btPersistentManifold& manifold) {
  for (int i = 0; i < manifold.getNumContacts(); ++i) {
    btManifoldPoint& point = manifold.getContactPoint(i);
    point.m_contactPointFlags &= ~BT_CONTACT_FLAG_LATERAL_FRICTION_INITIALIZED;
    const std::optional<DirectedFriction> friction = directedFriction(manifold, point);
    if (!friction) continue;
    point.m_contactPointFlags |= BT_CONTACT_FLAG_LATERAL_FRICTION_INITIALIZED;
    point.m_combinedFriction = friction->mu;
    point.m_lateralFrictionDir1 = friction->direction;
    point.m_lateralFrictionDir2 = point.m_normalWorldOnB.cross(friction->direction);
    frictions_.push_back({friction->mu2, friction->slip1, friction->slip2});
    point.m_userPersistentData = reinterpret_cast<void*>(static_cast<std::uintptr_t>(frictions_.size()));
  }
}

}  // namespace pongsim::physics
