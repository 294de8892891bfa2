#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/handles.hh"

namespace pongsim::python {

/// A spatial vector: the angular part, then the linear one.
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Kinematics and dynamics of a top-level model at its present state, in the velocities v of the model in
/// `StateVector`: M(q) dv/dt + h(q, v) = forces along v. Its links form trees, which hang on the world or move freely.
///
/// Recursive Newton-Euler and composite rigid body algorithms (Featherstone, Rigid Body Dynamics Algorithms, 2008,
/// tables 5.1 and 6.2), with all spatial vectors in world axes about one point, the origin of the model frame.
class Dynamics {
 public:
  /// Raises ValueError for a nested model, and Refused if the joints form a loop, are of a type without axes that is
  /// not fixed, or a screw or gearbox, or connect it to another model.
  explicit Dynamics(const Model& model, const Vector3& gravity);

  /// @return Number of velocities.
  Eigen::Index size() const { return size_; }
  /// @return M, symmetric.
  Eigen::MatrixXd massMatrix() const;
  /// @return M dv/dt + h.
  Eigen::VectorXd inverseDynamics(const Eigen::VectorXd& accelerations) const;
  /// @param point In the link frame.
  /// @return J with J v = the velocity of that point (3 rows) and the angular velocity of the link (3 rows), world
  /// frame.
  Eigen::MatrixXd jacobian(const Link& link, const Vector3& point) const;

 private:
  /// One of the velocities, along which a body moves relative to its parent.
  struct Freedom {
    Eigen::Index place;
    /// The body's velocity per unit of it.
    Vector6 axis;
    /// The rate at which that changes, because what carries it moves.
    Vector6 rate;
    double speed;
  };
  struct Body {
    LinkId link;
    /// Index of the body that it hangs on; none: the world.
    std::optional<std::size_t> parent;
    std::vector<Freedom> freedoms;
    Vector6 velocity;
    Matrix6 inertia;
  };
  struct Parts;
  struct Edge;
  struct Group;

  void addFree(const Link& root, const Pose& frame, Eigen::Index place);
  void addHanging(const Parts& parts, std::size_t root);
  void addRest(const Parts& parts, std::size_t begin);
  void addBody(const Link& link, std::optional<std::size_t> parent, std::vector<Freedom> freedoms);
  std::vector<Freedom> freedomsOf(const Edge& edge) const;
  Vector6 velocityOf(const Link& link) const;
  Matrix6 inertiaOf(const Link& link) const;

  Vector3 gravity_;
  /// What all spatial vectors are about, world frame.
  Vector3 origin_;
  /// Each after the one that it hangs on.
  std::vector<Body> bodies_;
  Eigen::Index size_ = 0;
};

}  // namespace pongsim::python
