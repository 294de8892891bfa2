#pragma once

#include <BulletDynamics/ConstraintSolver/btContactSolverInfo.h>
#include <BulletDynamics/ConstraintSolver/btTypedConstraint.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "physics/solving/block_matrix.hh"
#include "physics/solving/block_rows.hh"
#include "physics/solving/elimination.hh"
#include "physics/solving/joint_order.hh"
#include "physics/solving/row_ends.hh"

class btManifoldPoint;
class btPersistentManifold;

namespace pongsim::physics {

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
    /// A row of a joint without bounds, and in a tree its joint and its number among the joint's equations.
    bool isEquation = false;
    int joint = -1;
    int lane = 0;
  };

  /// Takes the bodies of a group in.
  /// @return The bodies that each joint acts on.
  std::span<const JointBodies> begin(std::span<btCollisionObject* const> bodies,
                                     std::span<btTypedConstraint* const> joints, const btContactSolverInfo& info);
  /// Takes their rows in.
  /// @param isTree Whether equations of joints stand side by side, for a `BlockMatrix`.
  void collect(std::span<btPersistentManifold* const> manifolds, std::span<btTypedConstraint* const> joints,
               bool isTree);

  std::span<const Row> rows() const { return rows_; }
  /// How many equations each joint has, in a tree.
  std::span<const int> equations() const { return equations_; }
  /// How many are not of friction.
  int unfrictionalRows() const { return unfrictionalRows_; }

  /// Sets the part of A = J M^-1 J^T at and behind the diagonal, a little softened: how much velocity along one row an
  /// impulse along another one gives. Rows that move nothing ask for nothing then.
  /// @param places Where each row is to stand in A.
  /// @param A All zero.
  void couple(std::span<const int> places, const UpperRows& A);
  /// Likewise in a tree.
  /// @param numbers Of rows with bounds, as A has them.
  void couple(const JointOrder& order, std::span<const int> numbers, BlockMatrix& A);

  /// Lists the bodies that rows with bounds act on, in a tree.
  /// @param numbers Of these rows.
  void listBoundedEnds(std::span<const int> numbers, std::vector<BlockMatrix::BoundedEnd>& list) const;

  /// In a tree, what is to be done before `apply`: takes in what the impulses of equations do.
  /// @param x Of both right-hand sides, as A has them; the second one null where there is none.
  void applyEquations(const JointOrder& order, const BlockMatrix& A, const double* x, const double* apart);

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
    /// Of its inverse inertia in the world frame the first two rows, column by column.
    Two inverseMoments[3];
    /// The last end of a row at it, -1 for none.
    int lastEnd;
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

  std::span<RowEnd> ends() { return {ends_.data(), endCount_}; }
  void takeBodies(std::span<btCollisionObject* const> bodies);
  void addJoint(btTypedConstraint& joint);
  void addJointRow(const JointRow& content);
  void addOneByOne(btTypedConstraint& joint, std::span<const JointRow> content, bool isTail);
  void addSideBySide(btTypedConstraint& joint, std::span<const JointRow> content, bool isTail);
  BlockRows::Lanes respond(BlockRows::End& end) const;
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
  /// @param own Of the row on the diagonal of A.
  void soften(Row& row, double& own) const;
  void pushApart(const Mover& mover) const;
  void measure(std::span<const double> impulses) const;

  double dt_ = 1;
  double errorReduction_ = 0;
  double contactErrorReduction_ = 0;
  double softness_ = 0;
  std::vector<Mover> movers_;
  std::vector<Row> rows_;
  /// The first `endCount_` are in use; none is made anew for each group.
  std::vector<RowEnd> ends_;
  std::size_t endCount_ = 0;
  BodyCoupling bodyCoupling_;
  std::vector<JointBodies> jointBodies_;
  bool isTree_ = false;
  /// Each row has two ends at most, at two bodies: the sums in A then are of two numbers, whose order does not count.
  bool isUsual_ = true;
  BlockRows blocks_;
  std::vector<int> equations_;
  std::vector<Contact> contacts_;
  std::vector<Measured> measured_;
  int jointRows_ = 0;
  int unfrictionalRows_ = 0;
  /// The velocity along the row that is made, without torques of this step, where it is one of friction.
  bool isFriction_ = false;
};

}  // namespace pongsim::physics
