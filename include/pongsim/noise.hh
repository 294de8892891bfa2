#pragma once

#include <array>
#include <optional>

#include "pongsim/export.hh"
#include "pongsim/random.hh"
#include "pongsim/sensor_settings.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// Falsifies one value as its `<noise>` says.
class PONGSIM_API Noise {
 public:
  /// None.
  Noise() = default;
  /// @param random Where the bias is drawn from now, and each value later.
  Noise(const NoiseSettings& settings, Random random);

  /// @param dt Time since the last call [s], in which the bias may have wandered.
  double apply(double value, double dt);

 private:
  NoiseSettings settings_;
  std::optional<Random> random_;
  double bias_ = 0;
};

/// Noise along three axes.
class PONGSIM_API Noise3 {
 public:
  /// None.
  Noise3() = default;
  /// @param random The streams of the three axes split off from it.
  Noise3(const NoiseSettings3& settings, Random& random);

  /// As `Noise::apply`.
  Vector3 apply(const Vector3& value, double dt);

 private:
  std::array<Noise, 3> axes_;
};

}  // namespace pongsim
