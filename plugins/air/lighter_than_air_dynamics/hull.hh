#pragma once

#include "pongsim/handles.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// The hull of an airship (Y. Li and M. Nahon, Modeling and Simulation of Airship Dynamics, Journal of Guidance,
/// Control, and Dynamics 30(6), 2007): equations 11 and 14 with these integrals over its length.
struct HullSettings {
  /// Of the air [kg/m^3].
  double density = 1.225;
  /// Coefficients of the inviscid and the viscous flow, of the force [m^2] and of the moment [m^3].
  double inviscidForce = 0;
  double viscousForce = 0;
  double inviscidMoment = 0;
  double viscousMoment = 0;
  /// Distance behind the origin at which the flow ceases to be potential [m].
  double separation = 0;
  /// Of the axial drag [m^2].
  double axialDrag = 0;
};

/// @param velocity Of the link frame's origin, in the link frame, with the nose ahead along x [m/s].
/// @param rates Angular velocity in the link frame [rad/s].
/// @return Force and torque at the origin, in the link frame.
Wrench hullWrench(const HullSettings& hull, const Vector3& velocity, const Vector3& rates);

}  // namespace pongsim
