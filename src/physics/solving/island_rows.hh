#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "physics/contacts/contact_point.hh"
#include "physics/joint.hh"
#include "physics/lcp/elimination.hh"
#include "physics/rigid_body.hh"
#include "physics/settings.hh"
#include "physics/solving/articulation.hh"
#include "physics/solving/joint_tree.hh"
#include "physics/solving/row_ends.hh"

class btPersistentManifold;

namespace pongsim::physics {

/// The constraint rows of an island for the direct solver: the Jacobian J, right-hand sides and bounds of
///   A x = b - J v,  A = J M^-1 J^T + compliance,
/// where x are the rows' impulses, v the bodies' velocities with the external forces of the step, and b the biases.
/// Keeps nothing but memory from island to island, and little of that, so that it stays in the nearest cache.
///
/// Rows of joints come first, in the joints' order, then those of contacts along the normal, then those of friction
/// along the surface, two for each point, then those against spinning about the normals.
///
/// In a tree, joints that hold its links are no rows but an `Articulation`: M^-1 is then the inertia of the bodies as
/// these joints hold them together, and v their velocity. Only their rows with bounds remain, and all rows of joints
/// that close loops.
class IslandRows {
 public:
  struct Row {
    /// b - J v [m/s or rad/s].
    double rhs = 0;
    /// Likewise for the push impulses, which correct penetration without adding velocity (Bullet's split impulse).
    double pushRhs = 0;
    /// Bounds of the impulse; those of friction are multiples of the normal row's impulse.
    double lowest = 0;
    double highest = 0;
    /// On the diagonal of A, beside that of all rows.
    double compliance = 0;
    /// For a row of friction, the contact's row along the normal; else -1.
    int normal = -1;
    /// A contact along the normal.
    bool isContact = false;
    /// A row of a joint without bounds.
    bool isEquation = false;
  };

  explicit IslandRows(const Settings& settings) : settings_(settings) {}

  /// Begins the island for a step of `dt` [s].
  /// @return The numbers of the bodies that each joint acts on.
  std::span<const JointBodies> begin(std::span<btRigidBody* const> bodies, std::span<Joint* const> joints, double dt);
  /// Adds all rows.
  /// @param tree Of these joints, or null for rows of all.
  void collect(std::span<btPersistentManifold* const> manifolds, std::span<Joint* const> joints, const JointTree* tree);

  /// Lets the rows see the bodies as the tree's joints hold them together; to be called before what follows.
  /// @return False where the inertia of a tree is not positive definite, or so nearly that it has no inverse.
  bool articulate();

  std::span<const Row> rows() const { return rows_; }
  /// Number of rows that are not friction.
  int unfrictionalRows() const { return unfrictionalRows_; }

  /// Adds A at and behind its diagonal. Right-hand sides of rows that move nothing become zero.
  /// @param places Of each row in A.
  /// @param A All zero.
  void assemble(std::span<const int> places, const UpperRows& A);

  /// Applies the rows' impulses to the bodies' velocities, and push impulses to their poses. Writes the impulses to the
  /// contact points and to measured joints.
  /// @param pushes Of rows without friction; empty without penetration.
  void apply(std::span<const double> impulses, std::span<const double> pushes);

 private:
  struct Body {
    btRigidBody* body = nullptr;
    /// With the external forces of this step: linear, angular.
    std::array<double, 6> velocity;
    /// The angular velocity without them: friction sees torques one step late.
    btVector3 angularBefore;
    std::array<double, 6> change{};
    std::array<double, 6> push{};
    /// The first two rows of its inverse inertia in the world frame, column by column.
    Two inverseMoments[3];
    /// Replaces these and the mass, where not null.
    const SpatialInertia* inertia = nullptr;
    /// The last end of a row at it, -1 for none.
    int lastEnd = -1;
  };
  /// A row of a joint whose reaction is measured.
  struct Measured {
    Joint* joint;
    JointRow content;
    std::size_t row;
  };

  std::span<RowEnd> ends() { return {ends_.data(), endCount_}; }
  int numberOf(const btRigidBody& body) const;
  void takeBodies(std::span<btRigidBody* const> bodies);
  std::array<double, 6> velocityUnderForces(const Body& body) const;
  void addJoint(Joint& joint);
  double addJointEnds(const Joint& joint, const JointRow& content);
  void addLink(Joint& joint, const JointTree::Link& link);
  void addJointRow(const Joint& joint, const JointRow& content);
  void takeInertia(const Body& body, Articulation::Inertia& inertia) const;
  void resolveRows();
  void applyToTree(std::span<const double> impulses, std::array<double, 6> Body::*to);
  void measureLinks(std::span<const double> impulses);
  void addContact(const SolverContact& contact);
  void addFrictionRow(const SolverContact& contact, const btVector3& direction, double mu, double slip, double motion,
                      int normal);
  void addTorsionRow(const SolverContact& contact, int normal);
  btVector3 velocityAt(const btRigidBody& body, const btVector3& arm) const;
  double addEnd(const btRigidBody& body, const btVector3& linear, const btVector3& angular);
  void regularize(Row& row, double& diagonal) const;
  void applyPush(const Body& body) const;
  void measure(std::span<const double> impulses) const;

  const Settings settings_;
  double dt_ = 1;
  std::vector<Body> bodies_;
  std::vector<Row> rows_;
  /// The first `endCount_` are in use; they are not constructed anew for each island.
  std::vector<RowEnd> ends_;
  std::size_t endCount_ = 0;
  BodyCoupling bodyCoupling_;
  std::vector<JointBodies> jointBodies_;
  /// Whether each row acts on two bodies at most: then each sum in A is of two numbers, in whichever order.
  bool areOfTwoBodies_ = true;
  /// Null without one.
  const JointTree* tree_ = nullptr;
  Articulation articulation_;
  /// The joints of links whose reactions are measured.
  std::vector<std::pair<Joint*, const JointTree::Link*>> measuredLinks_;
  std::vector<Articulation::Vector> wrenches_;
  /// Z, row after row, and Z^T x.
  std::vector<double> Z_;
  std::vector<double> z_;
  /// J M^-1 J^T of each row with the bodies' own inertia.
  std::vector<double> ownDiagonal_;
  std::vector<SolverContact> contacts_;
  std::vector<Measured> measured_;
  int jointRows_ = 0;
  /// Number of rows of joints that close loops of a tree, which come before those of links.
  std::size_t closingRows_ = 0;
  int unfrictionalRows_ = 0;
  /// Whether `addEnd` leaves out the torques of this step.
  bool isFriction_ = false;
};

}  // namespace pongsim::physics
