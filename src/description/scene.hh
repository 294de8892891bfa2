#pragma once

#include <cstddef>
#include <optional>

#include "description/color.hh"

namespace pongsim::description {

/// `<sky>`. Times of day in hours, 0 to 24.
struct Sky {
  double time = 10;
  double sunrise = 6;
  double sunset = 20;
  double cloudSpeed = 0.6;
  /// Direction in which the clouds move, counter-clockwise from x [rad].
  double cloudDirection = 0;
  /// Density of the clouds, 0 to 1.
  double humidity = 0.5;
  double cloudSize = 0.5;
  Color cloudAmbient{0.8F, 0.8F, 0.8F, 1};
  bool operator==(const Sky&) const = default;
};

/// `<fog>`
struct Fog {
  enum class Type { kNone, kConstant, kLinear, kQuadratic };
  Type type = Type::kNone;
  Color color{1, 1, 1, 1};
  /// Distances from the camera [m].
  double start = 1;
  double end = 100;
  double density = 1;
  bool operator==(const Fog&) const = default;
};

/// `<scene>`: background, fog, sky and ambient light.
struct Scene {
  Color ambient{0.4F, 0.4F, 0.4F, 1};
  Color background{0.7F, 0.7F, 0.7F, 1};
  bool hasShadows = true;
  bool hasGrid = true;
  bool showsOrigin = true;
  std::optional<Sky> sky;
  std::optional<Fog> fog;
  bool operator==(const Scene&) const = default;
};

}  // namespace pongsim::description
