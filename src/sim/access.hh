#pragma once

#include <optional>
#include <string>
#include <utility>

#include "physics/engine.hh"
#include "pongsim/handles.hh"
#include "pongsim/log.hh"
#include "world/entities.hh"
#include "world/state.hh"

namespace pongsim::sim {

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
    throw Gone(std::string("the ") + kindOf(id) + " with the id " + std::to_string(id.value) +
               " is not there any more");
  }
  return slot;
}

}  // namespace pongsim::sim
