#pragma once

#include <string>

#include "description/color.hh"
#include "pongsim/diagnostic.hh"
#include "pongsim/types.hh"

namespace pongsim::description {

enum class LightType { kPoint, kDirectional, kSpot };

/// A `<light>`.
struct Light {
  std::string name;
  SourcePosition position;
  LightType type = LightType::kPoint;
  /// Pose in the frame of its parent: the world or a link.
  Pose X_ParentLight;
  bool isOn = true;
  bool castsShadows = false;
  /// Whether the light itself is displayed, by programs that can.
  bool isVisualized = true;
  /// Factor applied to its colours.
  double intensity = 1;
  Color diffuse{1, 1, 1, 1};
  Color specular{0.1F, 0.1F, 0.1F, 1};
  /// Direction of the light, unit vector in its frame; for directional and spot lights.
  Vector3 direction{0, 0, -1};
  /// How far it reaches [m].
  double range = 10;
  /// At distance d the light is divided by constant + linear d + quadratic d^2.
  double constantAttenuation = 1;
  /// [1/m]
  double linearAttenuation = 1;
  /// [1/m^2]
  double quadraticAttenuation = 0;
  /// For spot lights: full angles of the cone that is fully lit and of the cone outside of which it is dark [rad].
  double innerAngle = 0;
  double outerAngle = 0;
  /// How fast the light falls off between the two; 1: linearly.
  double falloff = 0;
  bool operator==(const Light&) const = default;
};

}  // namespace pongsim::description
