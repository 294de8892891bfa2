#pragma once

#include <optional>
#include <vector>

#include "pongsim/geometry/solid.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// The fluid that a body displaces.
struct Displaced {
  /// [kg]
  double mass = 0;
  /// Mass times its centre relative to the origin of the body, along the axes of the world [kg m].
  Vector3 first = Vector3::Zero();
};

/// A fluid at rest, whose density may depend on the height.
class Fluid {
 public:
  /// @param density Below the first layer [kg/m^3].
  explicit Fluid(double density = 1000) : bottom_(density), top_(density) {}

  /// Adds a layer from that height [m] up to the next one.
  /// @return Whether there was none at this height; otherwise its density is replaced.
  bool addLayer(double from, double density);

  /// @return The density between two heights [m], if it is uniform there.
  std::optional<double> densityBetween(double lower, double upper) const {
    double density = bottom_;
    for (const Layer& layer : layers_) {
      if (layer.from > lower) return layer.from < upper ? std::nullopt : std::optional(density);
      density = layer.density;
    }
    return density;
  }

  /// @param height Of the origin of the body's frame in the world [m].
  /// @return The displaced fluid, wherever the boundaries of the layers cut the body: all of it with the highest
  /// layer's density, plus for the part below each boundary the difference of densities there.
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
    /// Lower boundary [m].
    double from;
    double density;
    /// Density below it minus its own.
    double drop;
  };

  double bottom_;
  /// Density of the highest layer.
  double top_;
  /// From the lowest to the highest.
  std::vector<Layer> layers_;
};

}  // namespace pongsim
