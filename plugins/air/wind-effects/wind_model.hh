#pragma once

#include <optional>

#include "pongsim/random.hh"
#include "pongsim/sensing/noise_set.hh"
#include "pongsim/state/state_archive.hh"
#include "pongsim/types.hh"
#include "wind_settings.hh"

namespace pongsim {

/// The velocity of the air, the same everywhere: a mean that is approached through low-pass filters, plus waves and
/// noise. The horizontal part's magnitude and direction and the vertical part are filtered separately.
class WindModel {
 public:
  /// @param random Stream of the noise.
  WindModel(const WindSettings& settings, const Random& random);

  /// @param mean World frame [m/s].
  /// @param time End of the step, for the waves.
  /// @param dt Length of the step [s].
  /// @return Current velocity, world frame [m/s].
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
  /// [degrees]; the first direction applies at once.
  std::optional<double> direction_;
  /// [m/s]
  double vertical_ = 0;
};

}  // namespace pongsim
