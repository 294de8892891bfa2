#pragma once

#include <BulletDynamics/ConstraintSolver/btContactSolverInfo.h>
#include <BulletDynamics/ConstraintSolver/btTypedConstraint.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

class btManifoldPoint;
class btPersistentManifold;

namespace pongsim::physics {

struct DirectedFriction;
struct PointSurface;

/// What joints and contacts ask of a group of bodies, as rows: how fast the bodies are to move along a direction of all
/// their motions, and within which bounds an impulse may be for it. Holds nothing but memory from group to group, and
/// little of that, so that it stays in the nearest cache.
///
/// Rows of joints come first, in the joints' order, then those of contacts in the normal direction, then those of
/// friction along the surface, two for each point, then those against turning about normals.
class GroupRows {
 public:
  struct Row {
    /// Velocity that is missing along the row [m/s or rad/s], and what takes penetration back without giving speed.
    double asked = 0;
    double askedApart = 0;
    /// Of the impulse; those of friction are multiples of the normal row's impulse.
    double lowest = 0;
    double highest = 0;
    /// By how much the row gives way, by each unit of impulse.
    double give = 0;
    /// Of a row of friction the row in the normal direction, else -1.
    int normal = -1;
    /// A contact in the normal direction without a spring of its own.
    bool isRigidContact = false;
  };

  /// Takes the rows of a group in.
  void collect(std::span<btCollisionObject* const> bodies, std::span<btPersistentManifold* const> manifolds,
               std::span<btTypedConstraint* const> joints, const btContactSolverInfo& info);

  std::span<const Row> rows() const { return rows_; }
  /// How many are not of friction.
  int unfrictionalRows() const { return unfrictionalRows_; }

  /// Sets the part of A = J M^-1 J^T at and behind the diagonal, a little softened: how much velocity along one row an
  /// impulse along another one gives. What is before the diagonal is zero. Rows that move nothing ask for nothing then.
  /// @param places Where each row is to stand in A.
  /// @param A `rows().size()` numbers squared, row after row.
  void couple(std::span<const int> places, double* A);

  /// Gives the bodies what the rows' impulses do: to their velocities, and without those to where they are.
  /// @param apart Of rows without friction; empty where there are none.
  void apply(std::span<const double> impulses, std::span<const double> apart);

 private:
  /// A body that moves.
  struct Mover {
    btRigidBody* body;
    /// With what forces add in this step: linear, angular.
    std::array<double, 6> velocity;
    /// The angular part without that: friction sees torques a step late.
    btVector3 turnBefore;
    std::array<double, 6> change;
    std::array<double, 6> push;
    /// The last end of a row at it, -1 for none.
    int lastEnd;
  };
  /// One end of a row: how the motion of the body there counts for the row (linear, angular), and how the body answers
  /// an impulse along it.
  struct End {
    std::array<double, 6> direction;
    std::array<double, 6> response;
    int row;
    int mover;
    /// The end before it at the same body.
    int before;
  };
  /// A row as a joint fills it in.
  struct JointRow {
    std::array<double, 3> linear1, angular1, linear2, angular2;
    double error, softness, lowest, highest;
  };
  /// A joint whose forces are measured, and one of its rows.
  struct Measured {
    btTypedConstraint* joint;
    JointRow content;
    std::size_t row;
  };
  struct Contact {
    btManifoldPoint* point;
    const btRigidBody* a;
    const btRigidBody* b;
    btVector3 armA;
    btVector3 armB;
    /// Along the second direction of friction, and how fast both slip.
    double mu2;
    double slip1;
    double slip2;
    double torsion;
    double torsionSlip;
  };

  void takeBodies(std::span<btCollisionObject* const> bodies);
  void addJoint(btTypedConstraint& joint);
  void addManifold(btPersistentManifold& manifold);
  void addContact(btPersistentManifold& manifold, btManifoldPoint& point);
  void addNormalRow(const Contact& contact);
  void addFrictionRows(const Contact& contact, int normal);
  void addFrictionRow(const Contact& contact, const btVector3& direction, double mu, double slip, double motion,
                      int normal);
  void addTorsionRow(const Contact& contact, int normal);
  btVector3 velocityAt(const btRigidBody& body, const btVector3& arm) const;
  void chooseDirections(const Contact& contact) const;
  /// @return The velocity along a row at the body with all forces.
  double addEnd(const btRigidBody& body, const btVector3& linear, const btVector3& angular);
  void pushApart(const Mover& mover) const;
  void measure(std::span<const double> impulses) const;

  double dt_ = 1;
  double errorReduction_ = 0;
  double contactErrorReduction_ = 0;
  double softness_ = 0;
  std::vector<Mover> movers_;
  std::vector<Row> rows_;
  std::vector<End> ends_;
  std::vector<Contact> contacts_;
  std::vector<Measured> measured_;
  int jointRows_ = 0;
  int unfrictionalRows_ = 0;
  /// The velocity along the row that is made, without torques of this step, where it is one of friction.
  bool isFriction_ = false;
};

}  // namespace pongsim::physics
