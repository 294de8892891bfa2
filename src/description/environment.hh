#pragma once

#include <string>

#include "pongsim/types.hh"

namespace pongsim::description {

/// `<atmosphere>`: air at the height zero of the world, and how it changes above.
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
  /// Whether the file says it.
  bool isGiven = false;
  std::string surfaceModel = "EARTH_WGS84";
  std::string worldFrameOrientation = "ENU";
  /// Of the world's origin [rad].
  double latitude = 0;
  double longitude = 0;
  /// Of the world's origin above the surface [m].
  double elevation = 0;
  /// Of the world frame, counter-clockwise from the orientation above [rad].
  double heading = 0;
  bool operator==(const SphericalCoordinates&) const = default;
};

/// What is around the bodies of a world.
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
