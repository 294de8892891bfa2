#pragma once

#include <atomic>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <thread>
#include <unordered_map>
#include <utility>

#include "physics/engine.hh"
#include "pongsim/handles.hh"
#include "pongsim/log.hh"
#include "pongsim/visual_colors.hh"
#include "sim/inputs/outside_changes.hh"
#include "sim/levels.hh"
#include "world/entities.hh"
#include "world/markers.hh"
#include "world/particles.hh"
#include "world/state.hh"

namespace pongsim {
class NoiseSet;
}

namespace pongsim::sim {

class SystemSlot;

/// Largest magnitudes of commands: far beyond reasonable ones, and about the limit of what physics can compute. Forces
/// [N, N m], velocities [m/s, rad/s].
inline constexpr double kMostForce = 1e10;
inline constexpr const char* kMostForceText = "1e10 N or N m";
inline constexpr double kMostVelocity = 1e8;
inline constexpr const char* kMostVelocityText = "1e8 m/s or rad/s";

/// @return Whether all values are within `most`; false for NaN.
inline bool isWithin(const Vector3& values, double most) {
  return std::abs(values.x()) <= most && std::abs(values.y()) <= most && std::abs(values.z()) <= most;
}

/// @return `isWithin` for both vectors, with fewer comparisons.
inline bool areWithin(const Vector3& a, const Vector3& b, double most) {
  // |a|, |b| <= sqrt(|a|^2 + |b|^2), in one comparison, which NaN fails
  return a.squaredNorm() + b.squaredNorm() <= most * most || (isWithin(a, most) && isWithin(b, most));
}

/// A running world: its entities, their state, the physics engine, and the loaded levels. The handles (`World`,
/// `Model`, `Link`, `Joint`) read and change it. Changes that concern several of these members are made by `Editor`.
class Access {
 public:
  /// @param description Must outlive this.
  explicit Access(const description::World& description, const physics::Settings& settings = physics::Settings())
      : entities(description), state(entities), engine(entities, settings) {}
  Access(const Access&) = delete;
  Access& operator=(const Access&) = delete;

  world::Entities entities;
  world::State state;
  physics::Engine engine;
  Levels levels{*this};
  Logger log{"commands"};
  /// The thread on which a system is running, if one is, and that system's first invalid command.
  std::atomic<std::thread::id> systemThread = std::thread::id();
  std::optional<std::string> badCommand = std::nullopt;

  /// Set while a system that stands outside is running on that thread.
  SystemSlot* outsider = nullptr;
  OutsideChanges outsideChanges = {};

  /// Reports an invalid command.
  void refuse(std::string what) {
    if (systemThread.load(std::memory_order_relaxed) != std::this_thread::get_id()) {
      log.warning(what);
    } else if (!badCommand) {
      badCommand = std::move(what);
    }
  }
  /// Models or joints were added or removed, and the systems have not been notified.
  bool hasChanged = false;
  /// Number of such changes since the start.
  std::uint64_t changes = 0;
  void noteChange() {
    hasChanged = true;
    ++changes;
  }
  /// Colours of visuals that were changed.
  std::map<VisualId, VisualColors> colors = {};
  /// How often that has been changed.
  std::uint64_t colorChanges = 0;
  /// Shapes that programs add for sensors, and for people.
  world::Markers sensorMarkers = {};
  world::Markers peopleMarkers = {};
  /// The noise of sensors; several where several systems simulate one.
  std::multimap<SensorId, NoiseSet*> noises = {};
  /// Ask `particlesNow`.
  world::Particles particles = {};
  /// @return The particles of the present emitters.
  world::Particles& particlesNow() {
    particles.follow(entities, changes);
    return particles;
  }
  /// For each name N, the number of names N_0, N_1, ... known to be taken; valid until an entity is removed.
  struct TakenNames {
    std::uint64_t removals = 0;
    std::unordered_map<std::string, int> counts = {};
  };
  TakenNames takenNames = {};
};

inline const char* kindOf(ModelId) { return "model"; }
inline const char* kindOf(LinkId) { return "link"; }
inline const char* kindOf(JointId) { return "joint"; }
inline const char* kindOf(CollisionId) { return "collision"; }
inline const char* kindOf(SensorId) { return "sensor"; }

/// @return The slot of an entity.
/// @throws Gone if it no longer exists.
template <class Id>
world::Slot slotOf(const Access& access, Id id) {
  const world::Slot slot = access.entities.slot(id);
  if (slot == world::kNoSlot) {
    if (access.entities.isSetAside(id.value)) {
      throw Gone(std::string("the ") + kindOf(id) + " with the id " + std::to_string(id.value) +
                 " is in a level that is not loaded");
    }
    throw Gone(std::string("the ") + kindOf(id) + " with the id " + std::to_string(id.value) + " no longer exists");
  }
  return slot;
}

}  // namespace pongsim::sim
