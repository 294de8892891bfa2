#include "world/particles.hh"

#include <algorithm>
#include <cmath>
#include <utility>

#include "description/limits.hh"

namespace pongsim::world {

namespace {

using description::ParticleEmitter;

/// @return A number from -1 to 1.
double symmetric(Random& draws) { return 2 * draws.uniform() - 1; }

/// @return Where a particle begins, in the frame of the emitter.
Vector3 beginning(const ParticleEmitter& emitter, Random& draws) {
  using enum ParticleEmitter::Type;
  if (emitter.type == kPoint) return Vector3::Zero();
  // across, up, along the direction of emission
  Vector3 share;
  do {
    share = {symmetric(draws), symmetric(draws), symmetric(draws)};
  } while ((emitter.type == kCylinder && share.head<2>().squaredNorm() > 1) ||
           (emitter.type == kEllipsoid && share.squaredNorm() > 1));
  const Vector3 half = share.cwiseProduct(emitter.size) / 2;
  return {half.z(), half.x(), half.y()};
}

}  // namespace

PlacedParticle placed(const Emitter& emitter, const Particle& particle, Time time) {
  const double age = toSeconds(time - particle.born), life = toSeconds(particle.dies - particle.born);
  const double growth = emitter.now.scaleRate * age;
  return {particle.start + particle.velocity * age, std::max(emitter.now.particleSize.x() + growth, 0.0),
          std::max(emitter.now.particleSize.y() + growth, 0.0), life > 0 ? std::clamp(age / life, 0.0, 1.0) : 1};
}

void Particles::clear() {
  emitters_.clear();
  isKnown_ = false;
}

void Particles::follow(const Entities& entities, std::uint64_t changes) {
  if (isKnown_ && changes == changes_) return;
  isKnown_ = true;
  changes_ = changes;
  std::erase_if(emitters_, [&](const Emitter& emitter) {
    return entities.slot(emitter.link) == kNoSlot && !entities.isSetAside(emitter.link.value);
  });
  for (const LinkRecord& link : entities.links()) {
    for (std::size_t i = 0; i < link.description->emitters.size(); ++i) {
      if (find(emitterId(link, i)) == nullptr) add(entities, link, i);
    }
  }
}

Emitter* Particles::find(EmitterId id) {
  const auto found = std::ranges::find(emitters_, id, &Emitter::id);
  return found == emitters_.end() ? nullptr : &*found;
}

void Particles::add(const Entities& entities, const LinkRecord& link, std::size_t number) {
  Emitter& added = emitters_.emplace_back();
  added.id = emitterId(link, number);
  added.link = link.id;
  added.atStart = added.now = link.description->emitters[number];
  added.streamName = "particles of " + entities.description().name + " " + entities.models()[link.model].scopedName +
                     "::" + link.description->name + "::" + added.now.name;
}

void Particles::advance(const Entities& entities, const State& state, double dt) {
  for (Emitter& emitter : emitters_) {
    const Slot link = entities.slot(emitter.link);
    if (link == kNoSlot) continue;
    std::erase_if(emitter.particles, [&](const Particle& particle) { return particle.dies <= state.time; });
    const ParticleEmitter& now = emitter.now;
    if (!now.isEmitting || now.lifetime <= 0) continue;
    if (now.duration > 0 && toSeconds(state.time - emitter.since) > now.duration) continue;
    emitter.due += now.rate * dt;
    const double whole = std::floor(emitter.due);
    emitter.due -= whole;
    const std::size_t room = kMost - std::min(emitter.particles.size(), kMost);
    const auto wanted = static_cast<std::size_t>(std::min(whole, static_cast<double>(room)));
    const Pose X_WorldEmitter = state.links[link].X_WorldLink * now.X_LinkEmitter;
    for (std::size_t i = 0; i < wanted; ++i) emit(emitter, X_WorldEmitter, state.time);
  }
}

void Particles::emit(Emitter& emitter, const Pose& X_WorldEmitter, Time time) const {
  const ParticleEmitter& now = emitter.now;
  Random draws = Random(seed_, emitter.streamName).at(emitter.count++);
  const Vector3 start = X_WorldEmitter * beginning(now, draws);
  const double speed = now.minVelocity + draws.uniform() * (now.maxVelocity - now.minVelocity);
  const Vector3 velocity = X_WorldEmitter.rotation * Vector3(speed, 0, 0);
  emitter.particles.push_back({start, velocity, time, time + fromSeconds(now.lifetime)});
}

void Particles::transfer(StateArchive& archive) {
  for (Emitter& emitter : emitters_) {
    archive(emitter.since);
    archive(emitter.due);
    archive.check(emitter.due >= 0 && emitter.due < 1);
    archive(emitter.count);
    std::uint64_t size = emitter.particles.size();
    archive(size);
    archive.check(size <= kMost);
    emitter.particles.resize(size);
    for (Particle& particle : emitter.particles) {
      archive(particle.start);
      archive(particle.velocity);
      archive(particle.born);
      archive(particle.dies);
      archive.check(particle.born <= particle.dies);
      archive.check(particle.start.cwiseAbs().maxCoeff() <= description::kFarthestSaved &&
                    particle.velocity.cwiseAbs().maxCoeff() <= description::kFastestSaved);
    }
  }
}

}  // namespace pongsim::world
