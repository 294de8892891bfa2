#include "fluid.hh"

namespace pongsim {

std::optional<double> Fluid::densityBetween(double lower, double upper) const {
  double density = bottom_;
  for (const auto& [height, next] : layers_) {
    if (height > lower) return height < upper ? std::nullopt : std::optional(density);
    density = next;
  }
  return density;
}

// Layer by layer from below: what lies below its upper edge, less what lies below its lower one. Summed up, each edge
// counts with the difference of the densities at it.
Displaced Fluid::displacedBy(const Solid& solid, const Vector3& up, double height) const {
  Displaced displaced;
  const auto add = [&displaced](double density, const Volume& part) {
    displaced.mass += density * part.size;
    displaced.first += density * part.size * part.center;
  };
  double density = bottom_;
  for (const auto& [edge, next] : layers_) {
    add(density - next, solid.below(up, edge - height));
    density = next;
  }
  add(density, solid.volume());
  return displaced;
}

}  // namespace pongsim
