#pragma once

#include <vector>

#include "pongsim/message.hh"
#include "pongsim/types.hh"

namespace pongsim::msgs {

/// One row of an `ignition.msgs.LaserScan`.
struct ScanRow {
  Time time{0};
  /// Angle of the first beam, counter-clockwise from straight ahead, and the step from one beam to the next [rad].
  double firstAngle = 0;
  double angleStep = 0;
  /// Elevation of the row [rad].
  double elevation = 0;
  /// [m] Infinite without a hit.
  std::vector<double> ranges;
};

/// @param scan An `ignition.msgs.LaserScan`, perhaps with fewer ranges than it claims.
/// @return The row closest to horizontal.
ScanRow levelRowOf(const Message& scan);

}  // namespace pongsim::msgs
