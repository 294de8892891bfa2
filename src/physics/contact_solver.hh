#pragma once

#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>

#include <vector>

namespace pongsim::physics {

/// Bullet's iterations, with friction that differs by direction and lets slip, as the surfaces of `<friction>` say, and
/// bounces as high as `<bounce>` says.
class ContactSolver : public btSequentialImpulseConstraintSolver {
 protected:
  void convertContacts(btPersistentManifold** manifolds, int count, const btContactSolverInfo& info) override;

 private:
  /// What the rows of one point get in addition to what Bullet makes of it.
  struct Friction {
    double mu2 = 0;
    /// [m/s/N]
    double slip1 = 0;
    double slip2 = 0;
  };

  void orient(btPersistentManifold& manifold);
  void settleBounce(btSolverConstraint& row, const btManifoldPoint& point, const btContactSolverInfo& info) const;
  static void addSlip(btSolverConstraint& row, double slip, double dt);

  /// Of the points whose friction has directions, in the order in which they are found.
  std::vector<Friction> frictions_;
};

}  // namespace pongsim::physics
