#include "marine_craft.hh"

#include <Eigen/Geometry>
#include <cmath>
#include <cstddef>

namespace pongsim {

MarineCraft::MarineCraft() {
  quadraticAbs.fill(Matrix6::Zero());
  quadratic.fill(Matrix6::Zero());
}

// C(v) v with Fossen's C, in the direction in which Fortress applies it: with the momenta l and h of the added mass, it
// is l x w, and l x v + h x w.
Vector6 MarineCraft::coriolisForce(const Vector6& velocity) const {
  const Vector6 momentum = addedMass.diagonal().cwiseProduct(velocity);
  const Eigen::Vector3d l = momentum.head<3>(), h = momentum.tail<3>();
  const Eigen::Vector3d v = velocity.head<3>(), w = velocity.tail<3>();
  Vector6 force;
  force.head<3>() = l.cross(w);
  force.tail<3>() = l.cross(v) + h.cross(w);
  return force;
}

Vector6 MarineCraft::dampingForce(const Vector6& velocity) const {
  Matrix6 slope = linear;
  for (std::size_t k = 0; k < 6; ++k) {
    const double speed = velocity[static_cast<Eigen::Index>(k)];
    slope += std::abs(speed) * quadraticAbs[k] + speed * quadratic[k];
  }
  return slope * velocity;
}

}  // namespace pongsim
