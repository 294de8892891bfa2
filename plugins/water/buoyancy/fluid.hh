#pragma once

#include <map>
#include <optional>

#include "pongsim/solid.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// What a body pushes aside.
struct Displaced {
  /// [kg]
  double mass = 0;
  /// Mass times where its centre is in the world frame [kg m].
  Vector3 first = Vector3::Zero();
};

/// A fluid at rest, whose density may change with the height.
class Fluid {
 public:
  /// @param density Of all that lies below the first layer [kg/m^3].
  explicit Fluid(double density = 1000) : bottom_(density) {}

  /// Adds what begins at that height [m], up to where another begins.
  /// @return Whether there was none at this height yet; else its density is replaced.
  bool addLayer(double from, double density) { return layers_.insert_or_assign(from, density).second; }

  /// @return The density of all between two heights [m], where it is the same.
  std::optional<double> densityBetween(double lower, double upper) const;

  /// @return What of the fluid a body displaces, wherever the edges of the layers cut it.
  Displaced displacedBy(const Solid& solid, const Pose& X_WorldSolid) const;

 private:
  double bottom_;
  /// Densities by the height where they begin.
  std::map<double, double> layers_;
};

}  // namespace pongsim
