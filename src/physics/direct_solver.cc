#include "physics/direct_solver.hh"

#include <cmath>
#include <initializer_list>
#include <limits>

namespace pongsim::physics {

namespace {

// an impulse beyond that comes from a matrix that could not be inverted [N s]
constexpr double kLargestImpulse = 1e6;

// Of a contact in its normal direction, by the mass that it moves. A body that stands on more points than three, as a
// robot on two wheels and two casters, so spreads its weight over them all. Were its points rigid, a difference of
// nanometres would lift the wheels off the ground, and they would spin.
constexpr double kContactSoftness = 1e-4;

// the method's infinity is that of IEEE, the rows' the largest number
double bound(double limit) {
  return std::abs(limit) >= SIMD_INFINITY ? std::copysign(std::numeric_limits<double>::infinity(), limit) : limit;
}

}  // namespace

btScalar DirectSolver::solveGroupCacheFriendlyIterations(btCollisionObject** bodies, int bodyCount,
                                                         btPersistentManifold** manifolds, int manifoldCount,
                                                         btTypedConstraint** joints, int jointCount,
                                                         const btContactSolverInfo& info, btIDebugDraw* debugDrawer) {
  collectRows();
  if (rows_.size() == 0) return 0;
  buildMatrix(info.m_globalCfm / info.m_timeStep);
  if (solveVelocities() && solvePositions()) return 0;
  return btSequentialImpulseConstraintSolver::solveGroupCacheFriendlyIterations(
      bodies, bodyCount, manifolds, manifoldCount, joints, jointCount, info, debugDrawer);
}

void DirectSolver::collectRows() {
  rows_.resizeNoInitialize(0);
  for (btConstraintArray* pool : {&m_tmpSolverNonContactConstraintPool, &m_tmpSolverContactConstraintPool,
                                  &m_tmpSolverContactFrictionConstraintPool}) {
    if (pool == &m_tmpSolverContactFrictionConstraintPool) unfrictionalRows_ = rows_.size();
    for (int i = 0; i < pool->size(); ++i) rows_.push_back(&(*pool)[i]);
  }
}

// how much velocity along row `a` an impulse along row `b` gives
double DirectSolver::coupling(const btSolverConstraint& a, const btSolverConstraint& b) const {
  double sum = 0;
  const auto add = [&](int body, const btVector3& linearA, const btVector3& angularA, const btVector3& linearB,
                       const btVector3& angularComponentB) {
    sum += (linearA * m_tmpSolverBodyPool[body].internalGetInvMass()).dot(linearB) + angularA.dot(angularComponentB);
  };
  if (a.m_solverBodyIdA == b.m_solverBodyIdA) {
    add(a.m_solverBodyIdA, a.m_contactNormal1, a.m_relpos1CrossNormal, b.m_contactNormal1, b.m_angularComponentA);
  }
  if (a.m_solverBodyIdA == b.m_solverBodyIdB) {
    add(a.m_solverBodyIdA, a.m_contactNormal1, a.m_relpos1CrossNormal, b.m_contactNormal2, b.m_angularComponentB);
  }
  if (a.m_solverBodyIdB == b.m_solverBodyIdA) {
    add(a.m_solverBodyIdB, a.m_contactNormal2, a.m_relpos2CrossNormal, b.m_contactNormal1, b.m_angularComponentA);
  }
  if (a.m_solverBodyIdB == b.m_solverBodyIdB) {
    add(a.m_solverBodyIdB, a.m_contactNormal2, a.m_relpos2CrossNormal, b.m_contactNormal2, b.m_angularComponentB);
  }
  return sum;
}

// A = J M^-1 J^T, symmetric, a little softened
void DirectSolver::buildMatrix(double softness) {
  const int rows = rows_.size();
  A_.resizeNoInitialize(rows * rows);
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j <= i; ++j) A_[i * rows + j] = A_[j * rows + i] = coupling(*rows_[i], *rows_[j]);
    A_[i * rows + i] += softness;
    // what friction slips by
    if (i >= unfrictionalRows_ && rows_[i]->m_cfm != 0) A_[i * rows + i] += rows_[i]->m_cfm / rows_[i]->m_jacDiagABInv;
    const bool isContact = i >= m_tmpSolverNonContactConstraintPool.size() && i < unfrictionalRows_;
    if (isContact) A_[i * rows + i] *= 1 + kContactSoftness;
  }
}

// the first `rows` of them, into `x_`; `b_` is set
bool DirectSolver::solve(int rows) {
  x_.resizeNoInitialize(rows);
  lowest_.resizeNoInitialize(rows);
  highest_.resizeNoInitialize(rows);
  normalOf_.resizeNoInitialize(rows);
  const int firstContact = m_tmpSolverNonContactConstraintPool.size();
  for (int i = 0; i < rows; ++i) {
    lowest_[i] = bound(rows_[i]->m_lowerLimit);
    highest_[i] = bound(rows_[i]->m_upperLimit);
    normalOf_[i] = i < unfrictionalRows_ ? -1 : firstContact + rows_[i]->m_frictionIndex;
    if (i >= unfrictionalRows_) {
      // times the impulse in the normal direction, which the method knows
      lowest_[i] = -rows_[i]->m_friction;
      highest_[i] = rows_[i]->m_friction;
    }
  }
  const Lcp::Problem problem{rows, &A_[0], rows_.size(), &b_[0], &lowest_[0], &highest_[0], &normalOf_[0]};
  if (!lcp_.solve(problem, &x_[0])) return false;
  for (int i = 0; i < rows; ++i) {
    if (!(std::abs(x_[i]) < kLargestImpulse)) return false;
  }
  return true;
}

bool DirectSolver::solveVelocities() {
  const int rows = rows_.size();
  b_.resizeNoInitialize(rows);
  for (int i = 0; i < rows; ++i) {
    const double inverse = rows_[i]->m_jacDiagABInv;
    b_[i] = inverse == 0 ? 0 : rows_[i]->m_rhs / inverse;
  }
  if (!solve(rows)) return false;
  for (int i = 0; i < rows; ++i) {
    btSolverConstraint& row = *rows_[i];
    btSolverBody& bodyA = m_tmpSolverBodyPool[row.m_solverBodyIdA];
    btSolverBody& bodyB = m_tmpSolverBodyPool[row.m_solverBodyIdB];
    const double change = x_[i] - row.m_appliedImpulse;
    row.m_appliedImpulse = x_[i];
    bodyA.internalApplyImpulse(row.m_contactNormal1 * bodyA.internalGetInvMass(), row.m_angularComponentA, change);
    bodyB.internalApplyImpulse(row.m_contactNormal2 * bodyB.internalGetInvMass(), row.m_angularComponentB, change);
  }
  return true;
}

// what takes penetration back moves the bodies without giving them speed, and their joints with them
bool DirectSolver::solvePositions() {
  bool penetrates = false;
  b_.resizeNoInitialize(unfrictionalRows_);
  for (int i = 0; i < unfrictionalRows_; ++i) {
    const double inverse = rows_[i]->m_jacDiagABInv;
    b_[i] = inverse == 0 ? 0 : rows_[i]->m_rhsPenetration / inverse;
    penetrates = penetrates || b_[i] != 0;
  }
  if (!penetrates) return true;
  if (!solve(unfrictionalRows_)) return false;
  for (int i = 0; i < unfrictionalRows_; ++i) {
    btSolverConstraint& row = *rows_[i];
    btSolverBody& bodyA = m_tmpSolverBodyPool[row.m_solverBodyIdA];
    btSolverBody& bodyB = m_tmpSolverBodyPool[row.m_solverBodyIdB];
    row.m_appliedPushImpulse = x_[i];
    bodyA.internalApplyPushImpulse(row.m_contactNormal1 * bodyA.internalGetInvMass(), row.m_angularComponentA, x_[i]);
    bodyB.internalApplyPushImpulse(row.m_contactNormal2 * bodyB.internalGetInvMass(), row.m_angularComponentB, x_[i]);
  }
  return true;
}

}  // namespace pongsim::physics
