#include "physics/solving/contact_solver.hh"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>
#include <cstdint>

#include "physics/contacts/contact_point.hh"
#include "physics/gearbox.hh"
#include "physics/settings.hh"
#include "physics/solving/bounce.hh"

namespace pongsim::physics {

void ContactSolver::convertContacts(btPersistentManifold** manifolds, int count, const btContactSolverInfo& info) {
  frictions_.clear();
  frictionsOfTurning_.clear();
  for (int i = 0; i < count; ++i) orient(*manifolds[i]);
  btSequentialImpulseConstraintSolver::convertContacts(manifolds, count, info);
  for (int i = 0; i < m_tmpSolverContactConstraintPool.size(); ++i) {
    btSolverConstraint& row = m_tmpSolverContactConstraintPool[i];
    auto* point = static_cast<btManifoldPoint*>(row.m_originalContactPoint);
    const auto rigidOf = [this](int body) { return m_tmpSolverBodyPool[body].m_originalBody; };
    row.m_rhs += row.m_jacDiagABInv *
                 bounceChange(*point, rigidOf(row.m_solverBodyIdA), rigidOf(row.m_solverBodyIdB), info.m_timeStep);
    // what is deep was put there: it is not to leap out; where contacts are soft, depth is a spring's
    const double most = isSoft(row) ? SIMD_INFINITY : kFastestParting * info.m_timeStep * row.m_jacDiagABInv;
    row.m_rhs += std::min(static_cast<double>(row.m_rhsPenetration), most);
    row.m_rhsPenetration = 0;
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
  addTorsionRows(info.m_timeStep);
}

bool ContactSolver::isSoft(const btSolverConstraint& row) {
  const auto& point = *static_cast<const btManifoldPoint*>(row.m_originalContactPoint);
  return (point.m_contactPointFlags & BT_CONTACT_FLAG_CONTACT_STIFFNESS_DAMPING) != 0;
}

// after the contacts, which come in the same order
void ContactSolver::addTorsionRows(double dt) {
  torsions_.resizeNoInitialize(0);
  int contact = 0;
  for (const Torsion& torsion : frictionsOfTurning_) {
    // what is not near enough has no row
    int found = contact;
    while (found < m_tmpSolverContactConstraintPool.size() &&
           m_tmpSolverContactConstraintPool[found].m_originalContactPoint != torsion.point) {
      ++found;
    }
    if (found == m_tmpSolverContactConstraintPool.size()) continue;
    contact = found;
    addTorsionRow(torsion, contact, dt);
  }
}

void ContactSolver::addTorsionRow(const Torsion& torsion, int contact, double dt) {
  const btSolverConstraint& normalRow = m_tmpSolverContactConstraintPool[contact];
  const btVector3 none(0, 0, 0);
  btSolverConstraint& row = torsions_.expandNonInitializing();
  row.m_contactNormal1 = row.m_contactNormal2 = none;
  row.m_relpos1CrossNormal = torsion.point->m_normalWorldOnB;
  row.m_relpos2CrossNormal = -torsion.point->m_normalWorldOnB;
  row.m_solverBodyIdA = normalRow.m_solverBodyIdA;
  row.m_solverBodyIdB = normalRow.m_solverBodyIdB;
  row.m_frictionIndex = contact;
  row.m_friction = torsion.torsion;
  row.m_lowerLimit = -torsion.torsion;
  row.m_upperLimit = torsion.torsion;
  row.m_appliedImpulse = row.m_appliedPushImpulse = 0;
  row.m_rhsPenetration = row.m_cfm = 0;
  double stiffness = 0;
  double turn = 0;
  const auto add = [&](int id, const btVector3& direction, btVector3& component) {
    const btSolverBody& body = m_tmpSolverBodyPool[id];
    const btRigidBody* rigid = body.m_originalBody;
    component = rigid == nullptr ? none : rigid->getInvInertiaTensorWorld() * direction * rigid->getAngularFactor();
    stiffness += component.dot(direction);
    turn += direction.dot(body.m_angularVelocity + body.m_externalTorqueImpulse);
  };
  add(row.m_solverBodyIdA, row.m_relpos1CrossNormal, row.m_angularComponentA);
  add(row.m_solverBodyIdB, row.m_relpos2CrossNormal, row.m_angularComponentB);
  row.m_jacDiagABInv = stiffness > 0 ? 1 / stiffness : 0;
  row.m_rhs = -turn * row.m_jacDiagABInv;
  addSlip(row, torsion.slip, dt);
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
  for (int i = 0; i < torsions_.size(); ++i) {
    btSolverConstraint& row = torsions_[i];
    const double bound =
        row.m_friction * static_cast<double>(m_tmpSolverContactConstraintPool[row.m_frictionIndex].m_appliedImpulse);
    const double before = row.m_appliedImpulse;
    const double wanted = before + row.m_rhs - before * row.m_cfm - velocityAlong(row) * row.m_jacDiagABInv;
    applyImpulse(row, std::clamp(wanted, -bound, bound) - before);
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
    const PointFriction found = settlePoint(point, manifold);
    if (found.torsion > 0) frictionsOfTurning_.push_back({&point, found.torsion, found.torsionSlip});
    if (!found.isDirected) continue;
    point.m_contactPointFlags |= BT_CONTACT_FLAG_LATERAL_FRICTION_INITIALIZED;
    frictions_.push_back({found.mu2, found.slip1, found.slip2});
    point.m_userPersistentData = reinterpret_cast<void*>(static_cast<std::uintptr_t>(frictions_.size()));
  }
}

}  // namespace pongsim::physics
