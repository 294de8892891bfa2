#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "physics/joint_motion.hh"
#include "physics/lcp/elimination.hh"
#include "physics/solving/joint_tree.hh"

namespace pongsim::physics {

/// How impulses change the velocities of bodies that joints hold together as trees, at a cost that is linear in their
/// number: the articulated-body algorithm, for velocities. Keeps nothing but memory from island to island.
///
/// Reference: R. Featherstone, Rigid Body Dynamics Algorithms, 2008, chapter 7.
class Articulation {
 public:
  /// Of a body, at its centre of mass: linear, angular. The last two are zero.
  using Vector = std::array<double, 8>;
  /// Symmetric; row after row.
  using Inertia = std::array<Vector, 6>;
  using Shift = std::array<double, 3>;
  /// What an impulse acts on, with its J.
  struct End {
    int body;
    const double* jacobian;
  };

  /// Begins an island.
  /// @param tree Must outlive the use of this.
  void begin(const JointTree& tree, std::size_t bodies);
  /// @param inertia To be set before `factor`.
  Inertia& inertia(std::size_t body) { return bodies_[body].inertia; }
  /// Sets how the joint of each link, one after the other, moves; with the velocity of its child relative to its parent
  /// before the impulses, at the joint.
  void add(const JointTree::Link& link, const JointMotion& motion, const btVector3& linear, const btVector3& angular);

  /// Must be called before what follows.
  /// @return False where the inertia is not positive definite.
  bool factor();

  /// The coordinates in which impulses are independent of each other: A = J M^-1 J^T = Z Z^T, Z having so many columns,
  /// a multiple of four.
  std::size_t coordinates() const { return width_; }
  /// Writes the row of Z of a row of J, all zero before.
  void resolve(std::span<const End> ends, double* z) const;
  /// @return The velocity changes of the bodies, until the next call: by what the joints ask for.
  std::span<const Vector> changeByJoints() { return change(own_, true); }
  /// @return Likewise by impulses x.
  /// @param z Z^T x.
  std::span<const Vector> changeBy(std::span<const double> z) { return change(z, false); }

  /// Adds to each body's vector, a wrench about its centre of mass, those of the links beyond it.
  void gather(std::span<Vector> wrenches) const;

  // for the functions in articulation.cc that have versions for wider registers
  struct Body {
    Inertia inertia;
    /// The wrench impulse by joints further out.
    Vector wrench;
    /// The first coordinate of a root, whose inertia becomes L of L L^T, with the inverse of its diagonal.
    std::size_t first;
    bool isRoot;
  };
  struct Freedom {
    Vector S;
    /// Articulated inertia times S.
    Vector U;
    /// D = S^T U + damping, and the square root of the inverse.
    double inverseD;
    double scale;
    double damping;
    double target;
  };
  struct Link {
    int body;
    int parent;
    /// The link of the parent, -1 for none.
    int next;
    /// From the body's centre of mass to the parent's.
    Shift shift;
    Vector bias;
    std::size_t first;
    std::size_t end;
  };

 private:
  std::span<const Vector> change(std::span<const double> z, bool isByJoints);

  const JointTree* tree_ = nullptr;
  std::vector<Body> bodies_;
  std::vector<Link> links_;
  std::vector<Freedom> freedoms_;
  /// What joints ask for, in the coordinates.
  std::vector<double> own_;
  std::vector<Vector> changes_;
  std::size_t width_ = 0;
};

/// Adds Z Z^T to A at and behind its diagonal.
/// @param Z So many rows as `places`, each `width` numbers wide, a multiple of four.
/// @param places Of each row in A.
void addSquare(const double* Z, std::size_t width, std::span<const int> places, const UpperRows& A);

}  // namespace pongsim::physics
