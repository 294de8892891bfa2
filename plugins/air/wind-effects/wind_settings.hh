#pragma once

#include "pongsim/diagnostic.hh"
#include "pongsim/element.hh"
#include "pongsim/sensing/noise_settings.hh"

namespace pongsim {

/// Filter, wave and noise of one part of the wind.
struct WindPartSettings {
  /// Time constant of the filter [s], above zero.
  double riseTime = 1;
  /// Amplitude of the added wave: a fraction of the magnitude, or degrees of the direction.
  double waveAmplitude = 0;
  /// [s], above zero.
  double wavePeriod = 1;
  NoiseSettings noise;
  bool operator==(const WindPartSettings&) const = default;
};

struct WindSettings {
  /// Of the horizontal part [m/s].
  WindPartSettings magnitude;
  /// Of the horizontal part, anticlockwise from x [degrees].
  WindPartSettings direction;
  /// Upwards [m/s]; it has no wave.
  WindPartSettings vertical;
  bool operator==(const WindSettings&) const = default;
};

/// Reads `<horizontal>` and `<vertical>` of a plugin. Unknown elements cause a warning.
/// @throws Error for an invalid value.
WindSettings readWindSettings(const Element& plugin, Diagnostics& diagnostics);

}  // namespace pongsim
