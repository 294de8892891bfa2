#pragma once

#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>

#include <vector>

namespace pongsim::physics {

/// Bullet's iterations, with friction that differs by direction and lets slip, as the surfaces of `<friction>` say,
/// bounces as high as `<bounce>` says, contacts that give way as `<contact>` says, and rows of gearboxes, which act on
/// three bodies. Depth is taken back by giving speed, of at most `kFastestParting` times the step. Impulses that take
/// it back without speed, as the direct method has them, would begin at nothing in each step, which fifty iterations
/// bring through a few bodies only: the lowest of fifty boxes sank in unevenly, and the stack fell.
class ContactSolver : public btSequentialImpulseConstraintSolver {
 protected:
  void convertContacts(btPersistentManifold** manifolds, int count, const btContactSolverInfo& info) override;
  void convertJoints(btTypedConstraint** joints, int count, const btContactSolverInfo& info) override;
  btScalar solveSingleIteration(int iteration, btCollisionObject** bodies, int bodyCount,
                                btPersistentManifold** manifolds, int manifoldCount, btTypedConstraint** joints,
                                int jointCount, const btContactSolverInfo& info, btIDebugDraw* debugDrawer) override;
  // depth is taken back by speed
  void solveGroupCacheFriendlySplitImpulseIterations(btCollisionObject**, int, btPersistentManifold**, int,
                                                     btTypedConstraint**, int, const btContactSolverInfo&,
                                                     btIDebugDraw*) override {}

 private:
  /// What the rows of one point get in addition to what Bullet makes of it.
  struct Friction {
    double mu2 = 0;
    /// [m/s/N]
    double slip1 = 0;
    double slip2 = 0;
  };

  /// What resists turning about the normal at a point.
  struct Torsion {
    const btManifoldPoint* point;
    /// [m], [rad/s/(N m)]
    double torsion;
    double slip;
  };

  void orient(btPersistentManifold& manifold);
  void addTorsionRows(double dt);
  void addTorsionRow(const Torsion& torsion, int contact, double dt);
  /// Adds to a row's impulse, and to the velocities of its bodies what that gives them.
  void applyImpulse(btSolverConstraint& row, double change);
  double velocityAlong(const btSolverConstraint& row);
  /// @return Whether the row is one of a contact that is not rigid.
  static bool isSoft(const btSolverConstraint& row);
  static void addSlip(btSolverConstraint& row, double slip, double dt);

  /// Of the points whose friction has directions, in the order in which they are found.
  std::vector<Friction> frictions_;
  /// Two rows of joints that are one, in ascending order: places of the first ones, which the second ones follow. What
  /// the one row asks for stands in the first.
  std::vector<int> ties_;
  /// In the order in which the points are found.
  std::vector<Torsion> frictionsOfTurning_;
  /// Rows against turning about the normals of contacts. Their `m_frictionIndex` is the contact's row, and their bound
  /// `m_friction` times its impulse.
  btConstraintArray torsions_;
};

}  // namespace pongsim::physics
