#pragma once

#include "pongsim/diagnostic.hh"
#include "pongsim/element.hh"
#include "pongsim/sensing/noise_settings.hh"

namespace pongsim {

/// How one part of the wind comes to what it is to be.
struct WindPartSettings {
  /// Time constant with which it does [s], above zero.
  double riseTime = 1;
  /// Of a wave that is added: a share of the magnitude, or degrees of the direction.
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

/// Reads `<horizontal>` and `<vertical>` of a plugin. Elements that are not known there are warned of.
/// @throws Error for a value that makes no sense.
WindSettings readWindSettings(const Element& plugin, Diagnostics& diagnostics);

}  // namespace pongsim
