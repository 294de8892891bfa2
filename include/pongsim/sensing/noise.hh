#pragma once

#include <optional>

#include "pongsim/export.hh"
#include "pongsim/random.hh"
#include "pongsim/sensing/noise_settings.hh"
#include "pongsim/state/state_archive.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// Noise on one value, as in its `<noise>`. It depends only on its random stream and the reading's simulated time, so a
/// reading does not depend on earlier subscribers.
class PONGSIM_API Noise {
 public:
  /// No noise.
  Noise() = default;
  /// @param random Its random stream; the bias is drawn immediately.
  Noise(const NoiseSettings& settings, Random random);

  /// Begins a reading. Call it for each reading that is due, even without subscribers, since the bias drifts.
  /// @param dt Time since the last due reading [s].
  void begin(Time time, double dt);

  /// @return Whether `apply` changes values.
  bool isOn() const { return stream_.has_value(); }

  /// @return The value with noise for the current reading; each call draws again.
  double apply(double value);

  void transfer(StateArchive& archive) { archive(bias_); }

 private:
  NoiseSettings settings_;
  std::optional<Random> stream_;
  /// For the current reading.
  std::optional<Random> draws_;
  double bias_ = 0;
};

}  // namespace pongsim
