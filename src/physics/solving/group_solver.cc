#include "physics/solving/group_solver.hh"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <cstddef>
#include <span>

namespace pongsim::physics {

namespace {

// of each contact point: one that keeps apart, two of friction
constexpr int kRowsPerContact = 3;

int countContactRows(std::span<btPersistentManifold* const> manifolds) {
  int rows = 0;
  for (const btPersistentManifold* manifold : manifolds) rows += kRowsPerContact * manifold->getNumContacts();
  return rows;
}

int countRows(std::span<btTypedConstraint* const> joints) {
  int rows = 0;
  for (btTypedConstraint* joint : joints) {
    btTypedConstraint::btConstraintInfo1 info;
    joint->getInfo1(&info);
    rows += info.m_numConstraintRows;
  }
  return rows;
}

/// @return Whether they may be those of a tree of links; fewer all act on one body.
bool mayBeTree(std::span<btTypedConstraint* const> joints) { return joints.size() > 2; }

}  // namespace

btScalar GroupSolver::solveGroup(btCollisionObject** bodies, int bodyCount, btPersistentManifold** manifolds,
                                 int manifoldCount, btTypedConstraint** joints, int jointCount,
                                 const btContactSolverInfo& info, btIDebugDraw* debugDrawer, btDispatcher* dispatcher) {
  const auto span = [](auto** first, int count) { return std::span(first, static_cast<std::size_t>(count)); };
  const std::span ofJoints = span(joints, jointCount);
  const std::span ofContacts = span(manifolds, manifoldCount);
  const int contactRows = countContactRows(ofContacts);
  const bool mayBeDirect =
      contactRows <= mostDirectRows_ && (mayBeTree(ofJoints) || contactRows + countRows(ofJoints) <= mostDirectRows_);
  if (mayBeDirect && direct_.solve(span(bodies, bodyCount), ofContacts, ofJoints, info)) return 0;
  return iterative_.solveGroup(bodies, bodyCount, manifolds, manifoldCount, joints, jointCount, info, debugDrawer,
                               dispatcher);
}

void GroupSolver::reset() { iterative_.reset(); }

}  // namespace pongsim::physics
