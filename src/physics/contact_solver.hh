#pragma once

#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>

#include <vector>

namespace pongsim::physics {

/// Bullet's iterations, with friction that differs by direction and lets slip, as the surfaces of `<friction>` say,
/// bounces as high as `<bounce>` says, and rows of gearboxes, which act on three bodies.
class ContactSolver : public btSequentialImpulseConstraintSolver {
 protected:
  void convertContacts(btPersistentManifold** manifolds, int count, const btContactSolverInfo& info) override;
  void convertJoints(btTypedConstraint** joints, int count, const btContactSolverInfo& info) override;
  btScalar solveSingleIteration(int iteration, btCollisionObject** bodies, int bodyCount,
                                btPersistentManifold** manifolds, int manifoldCount, btTypedConstraint** joints,
                                int jointCount, const btContactSolverInfo& info, btIDebugDraw* debugDrawer) override;

  /// Two rows of joints that are one, in ascending order: places of the first ones, which the second ones follow. What
  /// the one row asks for stands in the first.
  const std::vector<int>& tiedRows() const { return ties_; }
  /// Adds to a row's impulse, and to the velocities of its bodies what that gives them.
  void applyImpulse(btSolverConstraint& row, double change);

 private:
  /// What the rows of one point get in addition to what Bullet makes of it.
  struct Friction {
    double mu2 = 0;
    /// [m/s/N]
    double slip1 = 0;
    double slip2 = 0;
  };

  void orient(btPersistentManifold& manifold);
  double velocityAlong(const btSolverConstraint& row);
  void settleBounce(btSolverConstraint& row, const btManifoldPoint& point, const btContactSolverInfo& info) const;
  static void addSlip(btSolverConstraint& row, double slip, double dt);

  /// Of the points whose friction has directions, in the order in which they are found.
  std::vector<Friction> frictions_;
  std::vector<int> ties_;
};

}  // namespace pongsim::physics
