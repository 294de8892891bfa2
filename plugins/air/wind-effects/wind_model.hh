#pragma once

#include <optional>

#include "pongsim/random.hh"
#include "pongsim/sensing/noise_set.hh"
#include "pongsim/state/state_archive.hh"
#include "pongsim/types.hh"
#include "wind_settings.hh"

namespace pongsim {

/// The velocity of the air, the same everywhere: what it is to be on the average, reached with a delay, with waves and
/// noise on it. Magnitude and direction of the horizontal part and the vertical part go their own ways.
class WindModel {
 public:
  /// @param random Stream of the noise.
  WindModel(const WindSettings& settings, const Random& random);

  /// @param mean What it is to be on the average, world frame [m/s].
  /// @param time At the end of the step, by which the waves go.
  /// @param dt Length of the step [s].
  /// @return What it is, world frame [m/s].
  Vector3 update(const Vector3& mean, Time time, double dt);

  void reset(const Random& random);
  void transfer(StateArchive& archive);

 private:
  WindSettings settings_;
  NoiseSet noises_;
  Noise* magnitudeNoise_;
  Noise* directionNoise_;
  Noise* verticalNoise_;
  /// Horizontal [m/s].
  double magnitude_ = 0;
  /// [degrees]; the first one is there at once.
  std::optional<double> direction_;
  /// [m/s]
  double vertical_ = 0;
};

}  // namespace pongsim
