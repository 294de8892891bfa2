#include "physics/mass.hh"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <stdexcept>

namespace pongsim::physics {

PrincipalMass principalMass(const description::Inertial& inertial) {
  if (!(inertial.mass > 0) || !std::isfinite(inertial.mass)) {
    throw std::invalid_argument("its mass is not a positive number");
  }
  if (!inertial.moments.allFinite()) throw std::invalid_argument("its inertia is not finite");

  PrincipalMass result{inertial.mass, inertial.moments.diagonal(), inertial.X_LinkCom};

  // a tensor that is diagonal already keeps its axes, so that nothing is turned for the sake of rounding
  if (!inertial.moments.isDiagonal(0)) {
    const Eigen::SelfAdjointEigenSolver<Matrix3> solver(inertial.moments);
    Matrix3 axes = solver.eigenvectors();
    if (axes.determinant() < 0) axes.col(2) = -axes.col(2);
    result.moments = solver.eigenvalues();
    result.X_LinkBody.rotation = (inertial.X_LinkCom.rotation * Quaternion(axes)).normalized();
  }
  if (!(result.moments.minCoeff() > 0)) throw std::invalid_argument("its inertia is not positive definite");
  return result;
}

}  // namespace pongsim::physics
