#pragma once

#include <optional>
#include <vector>

#include "pongsim/geometry/solid.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// What a body pushes aside.
struct Displaced {
  /// [kg]
  double mass = 0;
  /// Mass times where its centre is from the origin of the body, along the axes of the world [kg m].
  Vector3 first = Vector3::Zero();
};

/// A fluid at rest, whose density may change with the height.
class Fluid {
 public:
  /// @param density Of all that lies below the first layer [kg/m^3].
  explicit Fluid(double density = 1000) : bottom_(density), top_(density) {}

  /// Adds what begins at that height [m], up to where another begins.
  /// @return Whether there was none at this height yet; else its density is replaced.
  bool addLayer(double from, double density);

  /// @return The density of all between two heights [m], where it is the same.
  std::optional<double> densityBetween(double lower, double upper) const {
    double density = bottom_;
    for (const Layer& layer : layers_) {
      if (layer.from > lower) return layer.from < upper ? std::nullopt : std::optional(density);
      density = layer.density;
    }
    return density;
  }

  /// @param height Of the origin of the body's frame in the world [m].
  /// @return What of the fluid a body displaces, wherever the edges of the layers cut it: all of it as if the highest
  /// layer were everywhere, and for what lies below each edge the difference of the densities at it.
  Displaced displacedBy(const Solid& solid, const Quaternion& R_WorldSolid, double height) const {
    Displaced displaced{top_ * solid.moments().volume, Vector3::Zero()};
    if (!solid.isCentered()) displaced.first = top_ * (R_WorldSolid * solid.moments().first);
    for (const Layer& layer : layers_) {
      const VolumeMoments below = solid.momentsBelowLevel(R_WorldSolid, layer.from - height);
      displaced.mass += layer.drop * below.volume;
      displaced.first += layer.drop * below.first;
    }
    return displaced;
  }

 private:
  struct Layer {
    /// Where it begins [m].
    double from;
    double density;
    /// By how much that is less than the density below it.
    double drop;
  };

  double bottom_;
  /// That of the highest layer.
  double top_;
  /// From the lowest to the highest.
  std::vector<Layer> layers_;
};

}  // namespace pongsim
