#pragma once

#include "pongsim/types.hh"

namespace pongsim::description {

/// `<fluid_added_mass>`: the inertia of the fluid that a body moves along, about the origin of the link frame and along
/// its axes, linear (x, y, z) before angular (p, q, r) [kg, kg m, kg m^2]. It is symmetric.
using AddedMass = Eigen::Matrix<double, 6, 6, Eigen::DontAlign>;

/// @param moments About the centre of mass, along the axes of its frame [kg m^2].
/// @return Whether a body with this mass [kg] and these moments has a positive definite inertia together with the added
/// mass: else there are motions whose energy is negative, and a push would be answered by a pull.
bool isPossible(const AddedMass& added, double mass, const Pose& X_LinkCom, const Matrix3& moments);

}  // namespace pongsim::description
