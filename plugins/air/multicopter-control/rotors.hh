#pragma once

#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "pongsim/element.hh"
#include "pongsim/handles.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// A rotor as the controller sees it: its effect on the body per square of its speed.
struct Rotor {
  /// Position in the x-y plane of the body [m].
  double x = 0;
  double y = 0;
  /// Thrust along the body's z axis per square of the speed [N s^2/rad^2].
  double forceConstant = 0;
  /// Reaction torque per thrust [m].
  double momentConstant = 0;
  /// 1 anticlockwise, -1 clockwise.
  int direction = 1;
};

/// Reads the `<rotor>`s of a `<rotorConfiguration>`.
/// @param body Link in whose axes the rotors are given.
/// @throws Error if a rotor is incomplete or names no joint of the model.
std::vector<Rotor> readRotors(const Element& configuration, const Model& model, const Link& body);

/// The allocation matrix: torques about x, y and z [N m] and thrust [N] per square of a rotor's speed, one column per
/// rotor. T. Lee, M. Leok and N. H. McClamroch, Control of Complex Maneuvers for a Quadrotor UAV using Geometric
/// Methods on SE(3), 2010, equation 1.
using Allocation = Eigen::Matrix<double, 4, Eigen::Dynamic>;
Allocation allocationOf(const std::vector<Rotor>& rotors);

/// @return The rank of the allocation matrix: 4 if torques and thrust are independent.
int rankOf(const Allocation& allocation);

}  // namespace pongsim
