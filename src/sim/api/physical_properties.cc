#include "pongsim/physical_properties.hh"

#include <cstdint>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "description/limits.hh"
#include "description/size.hh"
#include "pongsim/sensing/noise_set.hh"
#include "pongsim/sensing/sensor.hh"
#include "sim/api/access.hh"
#include "sim/edits/size_edits.hh"

namespace pongsim {

namespace {

constexpr const char* kDamping = "damping";

/// A collision as the engine knows it.
struct SurfacePlace {
  world::Slot link;
  std::size_t number;
};

SurfacePlace placeOf(const sim::Access& access, CollisionId id) {
  const world::Slot slot = sim::slotOf(access, id);
  const world::Slot link = access.entities.collisions()[slot].link;
  return {link, slot - access.entities.links()[link].firstCollision};
}

/// @return Why the number can't be used, if it is not within these bounds; NaN is not.
Outcome<void> checkRange(const std::string& what, double number, double least, double most) {
  if (number >= least && number <= most) return {};
  std::ostringstream text;
  text << what << " must be " << least << " to " << most << ", not " << number;
  return {text.str()};
}

Outcome<void> checkColor(const Vector3& color) {
  for (const double share : color) {
    if (auto checked = checkRange("a colour", share, 0, 1); !checked) return checked;
  }
  return {};
}

/// @return The number of the visual in its link.
std::size_t numberOf(const sim::Access& access, const Link& link, const Visual& visual) {
  const world::LinkRecord& record = access.entities.links()[sim::slotOf(access, link.id())];
  const std::uint64_t first = world::visualId(record, 0).value;
  const std::uint64_t number = visual.id().value - first;
  if (number >= record.description->visuals.size()) throw std::invalid_argument("the visual is not one of the link's");
  return number;
}

/// @return What the numbers must be for noise to be possible.
Outcome<void> checkNoise(const NoiseSettings& noise) {
  using description::kLargestCoefficient;
  for (const double mean : {noise.mean, noise.biasMean}) {
    if (auto checked = checkRange("a mean of noise", mean, -kLargestCoefficient, kLargestCoefficient); !checked) {
      return checked;
    }
  }
  for (const double number : {noise.standardDeviation, noise.biasStandardDeviation, noise.dynamicBiasStandardDeviation,
                              noise.dynamicBiasCorrelationTime, noise.precision}) {
    auto checked = checkRange("a deviation, time or precision of noise", number, 0, kLargestCoefficient);
    if (!checked) return checked;
  }
  return {};
}

}  // namespace

Outcome<void> PhysicalProperties::setMass(const Link& link, double mass, double inertiaFactor) {
  using description::kLargestMass;
  using description::kLeastMass;
  const std::string name = "link '" + link.scopedName() + "'";
  const world::Slot slot = sim::slotOf(*access_, link.id());
  if (access_->engine.mass(slot).mass == 0) return {name + " does not move, so its mass has no effect"};
  if (auto checked = checkRange("the mass of " + name, mass, kLeastMass, kLargestMass); !checked) return checked;
  if (auto checked = checkRange("the inertia's factor of " + name, inertiaFactor, kLeastMass, kLargestMass); !checked) {
    return checked;
  }
  const physics::Engine::Mass wanted{mass, inertiaFactor, access_->engine.mass(slot).stretch};
  if (!access_->engine.canHave(slot, wanted)) {
    return {"with this mass and inertia, " + name + " and its fluid_added_mass have no positive definite inertia"};
  }
  access_->engine.setMass(slot, wanted);
  return {};
}

double PhysicalProperties::inertiaFactor(const Link& link) const {
  return access_->engine.mass(sim::slotOf(*access_, link.id())).inertiaFactor;
}

PhysicalProperties::Surface PhysicalProperties::surface(const Collision& collision) const {
  const SurfacePlace place = placeOf(*access_, collision.id());
  const physics::Engine::Feel feel = access_->engine.feel(place.link, place.number);
  return {feel.mu, feel.mu2, feel.restitution};
}

Outcome<void> PhysicalProperties::setSurface(const Collision& collision, const Surface& surface) {
  using description::kLargestCoefficient;
  const SurfacePlace place = placeOf(*access_, collision.id());
  const std::string of = " of collision '" + collision.scopedName() + "'";
  for (const double friction : {surface.friction, surface.friction2}) {
    if (auto checked = checkRange("the friction" + of, friction, 0, kLargestCoefficient); !checked) return checked;
  }
  if (auto checked = checkRange("the restitution" + of, surface.restitution, 0, 1); !checked) return checked;
  access_->engine.setFeel(place.link, place.number, {surface.friction, surface.friction2, surface.restitution});
  return {};
}

Outcome<void> PhysicalProperties::setResistance(const Joint& joint, const char* what, double number, int axis) {
  const world::Slot slot = sim::slotOf(*access_, joint.id());
  const std::string of = " of joint '" + std::string(joint.name()) + "'";
  if (axis < 0 || axis >= joint.axisCount()) return {"there is no axis " + std::to_string(axis) + of};
  auto checked = checkRange(std::string("the ") + what + of, number, 0, description::kLargestCoefficient);
  if (!checked) return checked;
  const auto which = static_cast<std::size_t>(axis);
  physics::Engine::Resistance resistance = access_->engine.resistance(slot, which);
  (std::string_view(what) == kDamping ? resistance.damping : resistance.friction) = number;
  access_->engine.setResistance(slot, which, resistance);
  return {};
}

Outcome<void> PhysicalProperties::setColor(VisualId visual, const Vector3& color, bool glows) {
  if (auto checked = checkColor(color); !checked) return checked;
  access_->colors[visual] = {.diffuse = color, .emissive = glows ? std::optional(color) : std::nullopt};
  ++access_->colorChanges;
  return {};
}

Outcome<void> PhysicalProperties::setColors(VisualId visual, const VisualColors& colors) {
  constexpr std::optional<Vector3> VisualColors::*kColors[] = {&VisualColors::diffuse, &VisualColors::ambient,
                                                               &VisualColors::specular, &VisualColors::emissive};
  for (const auto color : kColors) {
    if (!(colors.*color)) continue;
    if (auto checked = checkColor(*(colors.*color)); !checked) return checked;
  }
  VisualColors& now = access_->colors[visual];
  for (const auto color : kColors) {
    if (colors.*color) now.*color = colors.*color;
  }
  ++access_->colorChanges;
  return {};
}

Outcome<void> PhysicalProperties::setDamping(const Joint& joint, double damping, int axis) {
  return setResistance(joint, kDamping, damping, axis);
}

Outcome<void> PhysicalProperties::setFriction(const Joint& joint, double friction, int axis) {
  return setResistance(joint, "friction", friction, axis);
}

PhysicalProperties::Bounds PhysicalProperties::bounds(const Joint& joint, int axis) const {
  const physics::Engine::Bounds bounds =
      access_->engine.bounds(sim::slotOf(*access_, joint.id()), static_cast<std::size_t>(axis));
  return {bounds.lower, bounds.upper, bounds.effort};
}

Outcome<void> PhysicalProperties::setBounds(const Joint& joint, const Bounds& bounds, int axis) {
  const world::Slot slot = sim::slotOf(*access_, joint.id());
  const std::string of = " of joint '" + std::string(joint.name()) + "'";
  if (axis < 0 || axis >= joint.axisCount()) return {"there is no axis " + std::to_string(axis) + of};
  // a comparison with NaN is false
  if (!(bounds.lower <= bounds.upper)) return {"the lower limit" + of + " must not be above the upper one"};
  if (!(bounds.effort >= 0)) return {"the effort" + of + " must not be below 0"};
  access_->engine.setBounds(slot, static_cast<std::size_t>(axis), {bounds.lower, bounds.upper, bounds.effort});
  return {};
}

std::vector<double> PhysicalProperties::size(const Collision& collision) const {
  const SurfacePlace place = placeOf(*access_, collision.id());
  return description::sizeOf(access_->entities.links()[place.link].description->collisions[place.number].geometry);
}

std::vector<double> PhysicalProperties::size(const Link& link, const Visual& visual) const {
  const world::LinkRecord& record = access_->entities.links()[sim::slotOf(*access_, link.id())];
  return description::sizeOf(record.description->visuals[numberOf(*access_, link, visual)].geometry);
}

Outcome<void> PhysicalProperties::setSize(const Collision& collision, std::span<const double> size,
                                          const Following& following) {
  const SurfacePlace place = placeOf(*access_, collision.id());
  return sim::setCollisionSize(*access_, place.link, place.number, size, {following.visuals, following.mass});
}

Outcome<void> PhysicalProperties::setSize(const Link& link, const Visual& visual, std::span<const double> size) {
  const world::Slot slot = sim::slotOf(*access_, link.id());
  return sim::setVisualSize(*access_, slot, numberOf(*access_, link, visual), size);
}

std::vector<PhysicalProperties::ReadingNoise> PhysicalProperties::noises(const Sensor& sensor) const {
  std::vector<ReadingNoise> noises;
  const auto [begin, end] = access_->noises.equal_range(sensor.id());
  for (auto set = begin; set != end; ++set) {
    for (std::size_t i = 0; i < set->second->size(); ++i) {
      noises.push_back({set->second->name(i), set->second->settings(i)});
    }
  }
  return noises;
}

Outcome<void> PhysicalProperties::setNoise(const Sensor& sensor, std::string_view value, const NoiseSettings& noise) {
  if (auto checked = checkNoise(noise); !checked) return {checked.error + ": sensor '" + sensor.scopedName() + "'"};
  std::string known;
  const auto [begin, end] = access_->noises.equal_range(sensor.id());
  for (auto set = begin; set != end; ++set) {
    for (std::size_t i = 0; i < set->second->size(); ++i) {
      known += (known.empty() ? "'" : ", '") + set->second->name(i) + "'";
      if (set->second->name(i) != value) continue;
      set->second->change(i, noise);
      return {};
    }
  }
  return {"sensor '" + sensor.scopedName() + "' has no noise of a value '" + std::string(value) + "'; " +
          (known.empty() ? "no system of the world gives its readings noise" : "it has " + known)};
}

void PhysicalProperties::add(const Sensor& sensor, NoiseSet& noises) { access_->noises.emplace(sensor.id(), &noises); }

void PhysicalProperties::remove(const NoiseSet& noises) {
  std::erase_if(access_->noises, [&noises](const auto& each) { return each.second == &noises; });
}

}  // namespace pongsim
