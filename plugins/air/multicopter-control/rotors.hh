#pragma once

#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "pongsim/element.hh"
#include "pongsim/handles.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// A rotor as the controller sees it: what it does to the body by the square of its speed.
struct Rotor {
  /// Where it is in the x-y plane of the body [m].
  double x = 0;
  double y = 0;
  /// Thrust along the body's z axis by the square of the speed [N s^2/rad^2].
  double forceConstant = 0;
  /// Torque against the turning by the thrust [m].
  double momentConstant = 0;
  /// 1 anticlockwise, -1 clockwise.
  int direction = 1;
};

/// Reads the `<rotor>`s of a `<rotorConfiguration>`.
/// @param body Link in whose axes the rotors are.
/// @throws Error where a rotor lacks something or names no joint of the model.
std::vector<Rotor> readRotors(const Element& configuration, const Model& model, const Link& body);

/// Torques about x, y and z [N m] and thrust [N] of the rotors, a column each, for the square of a speed of one. T.
/// Lee, M. Leok and N. H. McClamroch, Control of Complex Maneuvers for a Quadrotor UAV using Geometric Methods on
/// SE(3), 2010, equation 1.
using Allocation = Eigen::Matrix<double, 4, Eigen::Dynamic>;
Allocation allocationOf(const std::vector<Rotor>& rotors);

/// @return How many of torques and thrust the rotors can make independently: 4 where all.
int rankOf(const Allocation& allocation);

}  // namespace pongsim
