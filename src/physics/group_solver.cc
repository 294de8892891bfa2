#include "physics/group_solver.hh"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <cstddef>
#include <span>

namespace pongsim::physics {

namespace {

// of each contact point: one that keeps apart, two of friction
constexpr int kRowsPerContact = 3;

int countRows(btPersistentManifold** manifolds, int manifoldCount, btTypedConstraint** joints, int jointCount) {
  int rows = 0;
  for (int i = 0; i < manifoldCount; ++i) rows += kRowsPerContact * manifolds[i]->getNumContacts();
  for (int i = 0; i < jointCount; ++i) {
    btTypedConstraint::btConstraintInfo1 info;
    joints[i]->getInfo1(&info);
    rows += info.m_numConstraintRows;
  }
  return rows;
}

}  // namespace

btScalar GroupSolver::solveGroup(btCollisionObject** bodies, int bodyCount, btPersistentManifold** manifolds,
                                 int manifoldCount, btTypedConstraint** joints, int jointCount,
                                 const btContactSolverInfo& info, btIDebugDraw* debugDrawer, btDispatcher* dispatcher) {
  const bool small = countRows(manifolds, manifoldCount, joints, jointCount) <= mostDirectRows_;
  const auto span = [](auto** first, int count) { return std::span(first, static_cast<std::size_t>(count)); };
  if (small && direct_.solve(span(bodies, bodyCount), span(manifolds, manifoldCount), span(joints, jointCount), info)) {
    return 0;
  }
  return iterative_.solveGroup(bodies, bodyCount, manifolds, manifoldCount, joints, jointCount, info, debugDrawer,
                               dispatcher);
}

void GroupSolver::reset() { iterative_.reset(); }

}  // namespace pongsim::physics
