#pragma once

#include <string>

#include "pongsim/types.hh"

namespace pongsim::description {

/// `<atmosphere>`: air at height zero of the world, and how it changes with height.
struct Atmosphere {
  /// [K]
  double temperature = 288.15;
  /// [K/m]
  double temperatureGradient = -0.0065;
  /// [Pa]
  double pressure = 101325;
  bool operator==(const Atmosphere&) const = default;
};

/// `<spherical_coordinates>`: where on a planet the world is.
struct SphericalCoordinates {
  /// Whether the file specifies it.
  bool isGiven = false;
  std::string surfaceModel = "EARTH_WGS84";
  std::string worldFrameOrientation = "ENU";
  /// Latitude of the world's origin [rad].
  double latitude = 0;
  double longitude = 0;
  /// Height of the world's origin above the surface [m].
  double elevation = 0;
  /// Rotation of the world frame, counter-clockwise from the orientation above [rad].
  double heading = 0;
  bool operator==(const SphericalCoordinates&) const = default;
};

/// Surroundings that act on the bodies of a world.
struct Environment {
  /// World frame [m/s].
  Vector3 wind = Vector3::Zero();
  /// World frame [T].
  Vector3 magneticField{5.5645e-6, 22.8758e-6, -42.3884e-6};
  Atmosphere atmosphere;
  SphericalCoordinates sphericalCoordinates;
  bool operator==(const Environment&) const = default;
};

}  // namespace pongsim::description
