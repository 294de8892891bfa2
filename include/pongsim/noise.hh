#pragma once

#include <optional>

#include "pongsim/export.hh"
#include "pongsim/noise_settings.hh"
#include "pongsim/random.hh"
#include "pongsim/state_archive.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// Falsifies one value as its `<noise>` says. What it draws depends on its stream and on the simulated time of the
/// reading, so that a reading is the same whoever has listened before.
class PONGSIM_API Noise {
 public:
  /// None.
  Noise() = default;
  /// @param random Its stream; the bias is drawn from it now.
  Noise(const NoiseSettings& settings, Random random);

  /// Begins a reading. To be called for each that is due, also where nobody wants it, for the bias wanders on.
  /// @param dt Time since the last reading that was due [s].
  void begin(Time time, double dt);

  /// @return The value with the noise of the reading that has begun, drawn anew at each call.
  double apply(double value);

  void transfer(StateArchive& archive) { archive(bias_); }

 private:
  NoiseSettings settings_;
  std::optional<Random> stream_;
  /// For the reading that has begun.
  std::optional<Random> draws_;
  double bias_ = 0;
};

}  // namespace pongsim
