#pragma once

#include <array>
#include <string>
#include <vector>

#include "pongsim/element.hh"
#include "pongsim/sensing/noise_settings.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// A beam of a DVL: a cone with its tip in the sensor.
struct DvlBeam {
  int id = 0;
  /// Angle between opposite edges of the cone [rad].
  double aperture = 0;
  /// Its axis in the sensor frame, a unit vector; down for a beam without tilt.
  Vector3 axis = -Vector3::UnitZ();
};

/// `<gz:dvl>`
struct DvlSettings {
  enum class Type { kPiston, kPhasedArray };
  /// When a DVL publishes what it tracks.
  enum class When {
    kNever,
    kAlways,
    /// If it is more certain than the other.
    kBest
  };
  struct Mode {
    When when = When::kNever;
    /// Of a beam's speed [m/s].
    NoiseSettings noise;
  };

  Type type = Type::kPiston;
  std::vector<DvlBeam> beams;
  Mode bottom;
  Mode water;
  /// Names of quantities of the environment: the velocity of the water along the world's axes; empty: zero.
  std::array<std::string, 3> waterVelocity;
  /// Number of layers of the water that are measured.
  int bins = 5;
  /// Of the water that is measured: distances below the sensor [m].
  double near = 20;
  double far = 80;
  /// Angle between the rays of which a beam is made [rad].
  double resolution = 0.01;
  /// [m]
  double minRange = 0.1;
  double maxRange = 100;
  /// From the sensor frame to the frame in which velocities are published.
  Quaternion toReference = Quaternion::Identity();
};

/// @param sensor The `<sensor>` element.
/// @throws Error for what can't be used.
DvlSettings readDvl(const Element& sensor);

/// @return Unit vectors in the sensor frame that fill a beam's cone: its axis, and rings around it, `resolution` apart.
std::vector<Vector3> raysOf(const DvlBeam& beam, double resolution);

}  // namespace pongsim
