#pragma once

#include <vector>

#include "pongsim/message.hh"
#include "pongsim/types.hh"

namespace pongsim::msgs {

/// One row of an `ignition.msgs.LaserScan`.
struct ScanRow {
  Time time{0};
  /// Of the first beam, counter-clockwise from ahead, and from one to the next [rad].
  double firstAngle = 0;
  double angleStep = 0;
  /// How far up the row looks [rad].
  double elevation = 0;
  /// [m] Infinite where nothing is.
  std::vector<double> ranges;
};

/// @param scan An `ignition.msgs.LaserScan`, perhaps with less ranges than it says.
/// @return The row that looks most nearly level.
ScanRow levelRowOf(const Message& scan);

}  // namespace pongsim::msgs
