#include "physics/direct_solver.hh"

#include <algorithm>
#include <cmath>
#include <cstddef>
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
  tails_.clear();
  btConstraintArray& joints = m_tmpSolverNonContactConstraintPool;
  auto tie = tiedRows().begin();
  for (int i = 0; i < joints.size(); ++i) {
    rows_.push_back(&joints[i]);
    if (tie == tiedRows().end() || *tie != i) continue;
    ++tie;
    tails_.push_back({rows_.size() - 1, &joints[++i]});
  }
  jointRows_ = rows_.size();
  for (btConstraintArray* pool : {&m_tmpSolverContactConstraintPool, &m_tmpSolverContactFrictionConstraintPool}) {
    if (pool == &m_tmpSolverContactFrictionConstraintPool) unfrictionalRows_ = rows_.size();
    for (int i = 0; i < pool->size(); ++i) rows_.push_back(&(*pool)[i]);
  }
  for (int i = 0; i < torsionRows().size(); ++i) rows_.push_back(&torsionRows()[i]);
}

// by counting how many there are at each body
void DirectSolver::collectEnds() {
  const int bodies = m_tmpSolverBodyPool.size();
  endsOfBody_.resizeNoInitialize(0);
  endsOfBody_.resize(bodies + 1, 0);
  const auto forEach = [this](auto use) {
    std::size_t tail = 0;
    for (int i = 0; i < rows_.size(); ++i) {
      use(i, *rows_[i]);
      if (tail < tails_.size() && tails_[tail].row == i) use(i, *tails_[tail++].second);
    }
  };
  const auto moves = [this](int body) { return !m_tmpSolverBodyPool[body].internalGetInvMass().isZero(); };
  forEach([&](int, const btSolverConstraint& row) {
    for (const int body : {row.m_solverBodyIdA, row.m_solverBodyIdB}) {
      if (moves(body)) ++endsOfBody_[body + 1];
    }
  });
  for (int body = 0; body < bodies; ++body) endsOfBody_[body + 1] += endsOfBody_[body];
  ends_.resizeNoInitialize(endsOfBody_[bodies]);

  const auto add = [&](int row, int body, const btVector3& linear, const btVector3& angular,
                       const btVector3& angularComponent) {
    if (!moves(body)) return;
    // which comes to be where the next body's begin
    End& end = ends_[endsOfBody_[body]++];
    const btVector3 linearComponent = linear * m_tmpSolverBodyPool[body].internalGetInvMass();
    for (int i = 0; i < 3; ++i) {
      end.direction[i] = linear[i];
      end.direction[3 + i] = angular[i];
      end.response[i] = linearComponent[i];
      end.response[3 + i] = angularComponent[i];
    }
    end.row = row;
  };
  forEach([&](int i, const btSolverConstraint& row) {
    add(i, row.m_solverBodyIdA, row.m_contactNormal1, row.m_relpos1CrossNormal, row.m_angularComponentA);
    add(i, row.m_solverBodyIdB, row.m_contactNormal2, row.m_relpos2CrossNormal, row.m_angularComponentB);
  });
}

// how much velocity along one row an impulse along another one gives, by way of the body that these are at
void DirectSolver::addCouplings(const End* ends, int count) {
  const int rows = rows_.size();
  for (int i = 0; i < count; ++i) {
    const End& one = ends[i];
    double* const A = &A_[one.row * rows];
    for (int j = 0; j <= i; ++j) {
      const End& other = ends[j];
      double sums[2] = {0, 0};
      for (int k = 0; k < 6; k += 2) {
        sums[0] += one.direction[k] * other.response[k];
        sums[1] += one.direction[k + 1] * other.response[k + 1];
      }
      const double sum = sums[0] + sums[1];
      // two ends of one row, as tails have them, count both ways
      A[other.row] += j < i && other.row == one.row ? 2 * sum : sum;
    }
  }
}

// A = J M^-1 J^T, symmetric, a little softened
void DirectSolver::buildMatrix(double softness) {
  const int rows = rows_.size();
  A_.resizeNoInitialize(rows * rows);
  std::fill_n(&A_[0], rows * rows, 0.0);
  collectEnds();
  for (int body = 0, first = 0; body < m_tmpSolverBodyPool.size(); first = endsOfBody_[body++]) {
    if (endsOfBody_[body] > first) addCouplings(&ends_[first], endsOfBody_[body] - first);
  }
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < i; ++j) A_[j * rows + i] = A_[i * rows + j];
    A_[i * rows + i] += softness;
    // what friction slips by, and contacts that are not rigid
    const bool isContact = i >= jointRows_ && i < unfrictionalRows_;
    const bool givesWay = isContact ? isSoft(*rows_[i]) : i >= unfrictionalRows_ && rows_[i]->m_cfm != 0;
    if (givesWay) A_[i * rows + i] += rows_[i]->m_cfm / rows_[i]->m_jacDiagABInv;
    if (isContact && !givesWay) A_[i * rows + i] *= 1 + kContactSoftness;
  }
}

// the first `rows` of them, into `x_`; `b_` is set
bool DirectSolver::solve(int rows, bool isSameMatrix) {
  x_.resizeNoInitialize(rows);
  lowest_.resizeNoInitialize(rows);
  highest_.resizeNoInitialize(rows);
  normalOf_.resizeNoInitialize(rows);
  for (int i = 0; i < rows; ++i) {
    lowest_[i] = bound(rows_[i]->m_lowerLimit);
    highest_[i] = bound(rows_[i]->m_upperLimit);
    normalOf_[i] = i < unfrictionalRows_ ? -1 : jointRows_ + rows_[i]->m_frictionIndex;
    if (i >= unfrictionalRows_) {
      // times the impulse in the normal direction, which the method knows
      lowest_[i] = -rows_[i]->m_friction;
      highest_[i] = rows_[i]->m_friction;
    }
  }
  const Lcp::Problem problem{rows, &A_[0], rows_.size(), &b_[0], &lowest_[0], &highest_[0], &normalOf_[0]};
  const bool isSolved = isSameMatrix ? lcp_.solveWithSameMatrix(problem, &x_[0]) : lcp_.solve(problem, &x_[0]);
  if (!isSolved) return false;
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
  if (!solve(rows, false)) return false;
  for (int i = 0; i < rows; ++i) {
    // not by way of a sum, which would round it
    const double change = x_[i] - static_cast<double>(rows_[i]->m_appliedImpulse);
    applyImpulse(*rows_[i], change);
    rows_[i]->m_appliedImpulse = x_[i];
  }
  for (const Tail& tail : tails_) applyImpulse(*tail.second, x_[tail.row]);
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
  if (!solve(unfrictionalRows_, true)) return false;
  const auto push = [this](btSolverConstraint& row, double impulse) {
    btSolverBody& bodyA = m_tmpSolverBodyPool[row.m_solverBodyIdA];
    btSolverBody& bodyB = m_tmpSolverBodyPool[row.m_solverBodyIdB];
    row.m_appliedPushImpulse = impulse;
    bodyA.internalApplyPushImpulse(row.m_contactNormal1 * bodyA.internalGetInvMass(), row.m_angularComponentA, impulse);
    bodyB.internalApplyPushImpulse(row.m_contactNormal2 * bodyB.internalGetInvMass(), row.m_angularComponentB, impulse);
  };
  for (int i = 0; i < unfrictionalRows_; ++i) push(*rows_[i], x_[i]);
  for (const Tail& tail : tails_) push(*tail.second, x_[tail.row]);
  return true;
}

}  // namespace pongsim::physics
