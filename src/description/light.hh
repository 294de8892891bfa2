#pragma once

#include <string>

#include "description/color.hh"
#include "pongsim/diagnostic.hh"
#include "pongsim/types.hh"

namespace pongsim::description {

enum class LightType { kPoint, kDirectional, kSpot };

/// What a `<light>` says.
struct Light {
  std::string name;
  SourcePosition position;
  LightType type = LightType::kPoint;
  /// Pose in the frame of the world or the link that holds it.
  Pose X_ParentLight;
  bool isOn = true;
  bool castsShadows = false;
  /// It is shown itself, too, where a program shows such things.
  bool isVisualized = true;
  /// Factor of its colours.
  double intensity = 1;
  Color diffuse{1, 1, 1, 1};
  Color specular{0.1F, 0.1F, 0.1F, 1};
  /// Where it shines, unit vector in its frame; for directional and spot lights.
  Vector3 direction{0, 0, -1};
  /// Up to where it shines [m].
  double range = 10;
  /// At the distance d its light is divided by constant + linear d + quadratic d^2.
  double constantAttenuation = 1;
  /// [1/m]
  double linearAttenuation = 1;
  /// [1/m^2]
  double quadraticAttenuation = 0;
  /// Of a spot: opening angles of the cone that is bright and of the one outside of which it is dark [rad].
  double innerAngle = 0;
  double outerAngle = 0;
  /// How fast it gets dark between the two; 1: linearly.
  double falloff = 0;
  bool operator==(const Light&) const = default;
};

}  // namespace pongsim::description
