#include "fluid.hh"

namespace pongsim {

std::optional<double> Fluid::densityBetween(double lower, double upper) const {
  const auto above = layers_.upper_bound(lower);
  if (above != layers_.end() && above->first < upper) return std::nullopt;
  return above == layers_.begin() ? bottom_ : std::prev(above)->second;
}

// Layer by layer from below: what lies below its upper edge, less what lies below its lower one. Summed up, each edge
// counts with the difference of the densities at it.
Displaced Fluid::displacedBy(const Solid& solid, const Pose& X_WorldSolid) const {
  const Vector3 up = X_WorldSolid.rotation.conjugate() * Vector3::UnitZ();
  double mass = 0;
  Vector3 first = Vector3::Zero();
  double density = bottom_;
  for (const auto& [height, next] : layers_) {
    const Volume part = solid.below(up, height - X_WorldSolid.position.z());
    mass += (density - next) * part.size;
    first += (density - next) * part.size * part.center;
    density = next;
  }
  mass += density * solid.volume().size;
  first += density * solid.volume().size * solid.volume().center;
  return {mass, mass * X_WorldSolid.position + X_WorldSolid.rotation * first};
}

}  // namespace pongsim
