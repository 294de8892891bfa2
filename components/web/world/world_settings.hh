#pragma once

#include <array>
#include <optional>

namespace pongsim::web {

/// Current values of a world's settings that can be changed while it runs.
struct WorldSettings {
  bool isPaused = false;
  /// Target in simulated seconds per second of wall time; 0: as fast as possible.
  double realTimeFactor = 0;
  /// Of the last step [s]; nothing if there has been none.
  std::optional<double> stepSize;
  /// In the world frame [m/s^2].
  std::array<double, 3> gravity{};
  bool operator==(const WorldSettings&) const = default;
};

}  // namespace pongsim::web
