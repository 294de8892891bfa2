#pragma once

#include <array>
#include <optional>

namespace pongsim::web {

/// What of a world can be set while it runs, as it is now.
struct WorldSettings {
  bool isPaused = false;
  /// Simulated seconds a second that it keeps to; 0: as many as possible.
  double realTimeFactor = 0;
  /// Of the last step [s]; nothing where there has been none.
  std::optional<double> stepSize;
  /// In the world frame [m/s^2].
  std::array<double, 3> gravity{};
  bool operator==(const WorldSettings&) const = default;
};

}  // namespace pongsim::web
