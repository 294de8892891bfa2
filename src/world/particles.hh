#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "description/particle_emitter.hh"
#include "pongsim/random.hh"
#include "pongsim/scene.hh"
#include "pongsim/state/state_archive.hh"
#include "pongsim/types.hh"
#include "world/entities.hh"
#include "world/state.hh"

namespace pongsim::world {

/// @return The id of a particle emitter of the link's file; those of the visuals are before it.
inline EmitterId emitterId(const LinkRecord& link, std::size_t emitter) {
  return EmitterId{link.id.value + 1 + link.description->visuals.size() + emitter};
}

/// One that flies in a straight line, in the world frame.
struct Particle {
  Vector3 start;
  Vector3 velocity;
  Time born{0};
  Time dies{0};
};

/// An emitter and what it has emitted.
struct Emitter {
  EmitterId id;
  LinkId link;
  /// Of its random stream.
  std::string streamName;
  /// As in the file.
  description::ParticleEmitter atStart;
  description::ParticleEmitter now;
  /// What has changed it since: bytes of a message.
  std::string changes;
  /// Since when it has been emitting, for the duration.
  Time since{0};
  /// Share of the next particle that is due.
  double due = 0;
  /// Number of particles emitted.
  std::uint64_t count = 0;
  std::vector<Particle> particles;
};

/// A particle at a time.
struct PlacedParticle {
  Vector3 place;
  /// [m]
  double width = 0;
  double height = 0;
  /// Age as a share of its life, 0 to 1.
  double share = 0;
};
PlacedParticle placed(const Emitter& emitter, const Particle& particle, Time time);

/// The particle emitters of a world and their particles.
class Particles {
 public:
  /// Of one emitter, as in Fortress.
  static constexpr std::size_t kMost = 5000;

  /// @param seed Of the run.
  void setSeed(std::uint64_t seed) { seed_ = seed; }
  std::uint64_t seed() const { return seed_; }

  /// Adds emitters of new links, and forgets those of removed ones.
  /// @param changes A number that is another one whenever links may have been added or removed.
  void follow(const Entities& entities, std::uint64_t changes);

  /// Emits what is due in the step that ends with this state, and forgets particles at the end of their life.
  /// @param dt [s]
  void advance(const Entities& entities, const State& state, double dt);

  /// Forgets everything, as at the start.
  void clear();

  std::vector<Emitter>& emitters() { return emitters_; }
  const std::vector<Emitter>& emitters() const { return emitters_; }
  /// @return Null if there is none.
  Emitter* find(EmitterId id);

  /// Particles and their numbers, but not the emitters' settings.
  void transfer(StateArchive& archive);

 private:
  void add(const Entities& entities, const LinkRecord& link, std::size_t number);
  void emit(Emitter& emitter, const Pose& X_WorldEmitter, Time time) const;

  std::uint64_t seed_ = 0;
  std::uint64_t changes_ = 0;
  bool isKnown_ = false;
  std::vector<Emitter> emitters_;
};

}  // namespace pongsim::world
