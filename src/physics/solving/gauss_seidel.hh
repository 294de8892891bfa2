#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <cstddef>
#include <span>
#include <vector>

#include "physics/contacts/contact_point.hh"
#include "physics/joint.hh"
#include "physics/rigid_body.hh"
#include "physics/settings.hh"

class btPersistentManifold;

namespace pongsim::physics {

/// Projected Gauss-Seidel (sequential impulses): sweeps over the rows of an island, each time giving one row the
/// impulse that it lacks, within its bounds. Contacts start from 0.85 of their last impulse (warm start). Friction is
/// bounded by the current normal impulse. Gives the bits of Bullet's btSequentialImpulseConstraintSolver, but for
/// islands with gearboxes or torsional friction, whose rows Bullet does not have, and contacts of two moving bodies
/// that do not just touch (see `SolverContact`).
///
/// Penetration is corrected by a bias, so it adds velocity, at most `kMaxPushAcceleration` times the step. Push
/// impulses as the direct solver has them start from zero in each step, and fifty sweeps bring them through a few
/// bodies only: the lowest of fifty boxes sank in unevenly, and the stack fell.
///
/// Reference: E. Catto, Iterative dynamics with temporal coherence, GDC 2005.
class GaussSeidel {
 public:
  explicit GaussSeidel(const Settings& settings) : settings_(settings) {}

  /// Gives the bodies their velocities at the end of the step of `dt` [s], and writes the impulses to the contact
  /// points and to measured joints.
  void solve(std::span<btRigidBody* const> bodies, std::span<btPersistentManifold* const> manifolds,
             std::span<Joint* const> joints, double dt);

 private:
  struct Body {
    btRigidBody* body;
    double inverseMass;
    /// Changes of velocity by the external forces of the step, and by the impulses so far.
    btVector3 forceChange;
    btVector3 torqueChange;
    btVector3 linearChange;
    btVector3 angularChange;
    /// Replaces mass and moments, where not null.
    const SpatialInertia* inertia = nullptr;
  };
  struct Motion {
    btVector3 linear;
    btVector3 angular;
  };
  /// J of a body's angular velocity, and how a unit impulse of the row changes that: I^-1 J^T.
  struct Angular {
    btVector3 jacobian;
    btVector3 response;
  };
  struct Row {
    /// Numbers in `bodies_`.
    std::size_t a;
    std::size_t b;
    /// J of the linear velocity of `a`; that of `b` is its negative.
    btVector3 linear;
    Angular angularA;
    Angular angularB;
    /// 1 / (J M^-1 J^T), plus the compliance.
    double effectiveMass = 0;
    /// The impulse that the row needs, as long as no row has an impulse.
    double rhs = 0;
    /// Fraction of its impulse that the row gives way by (constraint force mixing).
    double cfm = 0;
    double lowest = 0;
    double highest = kInfinity;
    double impulse = 0;
  };
  /// Its impulse is at most `mu` times that of a contact.
  struct FrictionRow : Row {
    double mu;
    std::size_t normal;
  };
  /// Of the rows of a gearbox: the third body.
  struct ThirdBody {
    std::size_t row;
    std::size_t body;
    Angular angular;
  };
  /// A joint and where its rows begin.
  struct MeasuredJoint {
    Joint* joint;
    std::size_t first;
  };

  void takeBodies(std::span<btRigidBody* const> bodies);
  std::size_t numberOf(const btRigidBody& body) const;
  void addJoint(Joint& joint);
  void addContact(const SolverContact& contact);
  void addFriction(const SolverContact& contact, const btVector3& direction, double mu, double slip, double motion);
  void addTorsion(const SolverContact& contact);
  Row makeRow(const SolverContact& contact, const btVector3& direction, double compliance) const;
  /// @return The velocity along the row at the end of the step, if no row had an impulse.
  double velocityAlong(const Row& row, bool withTorques) const;
  void addSlip(Row& row, double slip) const;
  double inverseMassOf(const Row& row) const;
  Motion responseOf(std::size_t number, const btVector3& linear, const btVector3& angular) const;
  void applyGenerally(std::size_t number, const btVector3& linear, const btVector3& angular, double impulse);

  bool sweep();
  bool improve(Row& row, double ofThirdBody = 0);
  bool improve(FrictionRow& row);
  void apply(const Row& row, double impulse);
  void writeBack();

  const Settings settings_;
  double dt_ = 0;
  /// The first one stands for all that do not move.
  std::vector<Body> bodies_;
  /// Whether any of them has a spatial inertia.
  bool isGeneral_ = false;
  std::vector<Row> jointRows_;
  std::vector<ThirdBody> thirdBodies_;
  std::vector<MeasuredJoint> measured_;
  std::vector<Row> normals_;
  /// Two for each contact, and those against spinning about the normal.
  std::vector<FrictionRow> frictions_;
  std::vector<FrictionRow> torsions_;
  /// Of each contact.
  std::vector<btManifoldPoint*> points_;
};

}  // namespace pongsim::physics
