#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

#include "physics/engine.hh"
#include "pongsim/handles.hh"
#include "pongsim/log.hh"
#include "sim/levels.hh"
#include "world/entities.hh"
#include "world/state.hh"

namespace pongsim::sim {

/// No command of a system may be larger: far more than is ever meant, and as much as the physics can follow without
/// losing all meaning. Forces [N, N m], and velocities [m/s, rad/s].
inline constexpr double kMostForce = 1e10;
inline constexpr const char* kMostForceText = "1e10 N or N m";
inline constexpr double kMostVelocity = 1e8;
inline constexpr const char* kMostVelocityText = "1e8 m/s or rad/s";

/// @return Whether all are within `most`, which what is not a number is not.
inline bool isWithin(const Vector3& values, double most) {
  return std::abs(values.x()) <= most && std::abs(values.y()) <= most && std::abs(values.z()) <= most;
}

/// @return Likewise of both together, by fewer comparisons.
inline bool areWithin(const Vector3& a, const Vector3& b, double most) {
  // neither is longer than both together, which is not below what is not a number
  return a.squaredNorm() + b.squaredNorm() <= most * most || (isWithin(a, most) && isWithin(b, most));
}

/// A group of entities that is set aside: not there for anybody, and kept as it is until it comes back.
struct Shelved {
  world::Records entities;
  world::StatePart state;
  physics::SetAside bodies;
};

/// What the handles (`World`, `Model`, `Link`, `Joint`) reach into.
class Access {
 public:
  world::Entities& entities;
  world::State& state;
  physics::Engine& engine;
  Logger log{"commands"};
  /// Whether a system runs now, and the first of its commands that made no sense.
  bool inSystem = false;
  std::optional<std::string> badCommand = std::nullopt;

  /// A command can't be followed.
  void refuse(std::string what) {
    if (!inSystem) {
      log.warning(what);
    } else if (!badCommand) {
      badCommand = std::move(what);
    }
  }
  /// Models or joints have come or gone, and the systems do not know yet.
  bool hasChanged = false;
  /// How often they have.
  std::uint64_t changes = 0;
  void noteChange() {
    hasChanged = true;
    ++changes;
  }
  /// What is set aside, in the order of ids.
  std::vector<Shelved> shelf = {};
  /// The ids of all models, sensors and actors in it.
  std::unordered_set<std::uint64_t> shelvedIds = {};
  Levels levels = {};
};

inline const char* kindOf(ModelId) { return "model"; }
inline const char* kindOf(LinkId) { return "link"; }
inline const char* kindOf(JointId) { return "joint"; }
inline const char* kindOf(CollisionId) { return "collision"; }
inline const char* kindOf(SensorId) { return "sensor"; }

/// @return The slot of what a handle leads to.
/// @throws Gone if it is not there any more.
template <class Id>
world::Slot slotOf(const Access& access, Id id) {
  const world::Slot slot = access.entities.slot(id);
  if (slot == world::kNoSlot) {
    if (access.shelvedIds.contains(id.value)) {
      throw Gone(std::string("the ") + kindOf(id) + " with the id " + std::to_string(id.value) +
                 " is set aside with its level");
    }
    throw Gone(std::string("the ") + kindOf(id) + " with the id " + std::to_string(id.value) +
               " is not there any more");
  }
  return slot;
}

}  // namespace pongsim::sim
