#pragma once

#include "pongsim/element.hh"
#include "pongsim/handles.hh"

namespace pongsim {

/// How much a wheel slips: slip, as a fraction of the rim's speed, per friction force, as a fraction of the load.
struct SlipCompliance {
  /// Along the wheel's axis.
  double lateral = 0;
  /// Across it.
  double longitudinal = 0;
};

/// A `<wheel>` of WheelSlip.
struct SlippingWheel {
  Link link;
  /// The only one of the link.
  Collision collision;
  /// The one on which it turns.
  Joint joint;
  /// [m]
  double radius;
  /// [N]
  double load;
  /// In the file.
  SlipCompliance compliance;

  /// Sets the slip of the collision for the next step: compliances have no unit, slips are in m/s/N, so they are scaled
  /// by the current speed of the rim and by the load. (K. Yoshida and H. Hamano, "Motion Dynamics of a Rover with
  /// Slip-Based Traction Model", ICRA 2002, equation 1.)
  void slip(const SlipCompliance& now);
};

/// @param element A `<wheel>` in the `<plugin>` of WheelSlip in `model`.
/// @throws Error with a position where it can't slip.
SlippingWheel slippingWheel(const Element& element, const Model& model);

}  // namespace pongsim
