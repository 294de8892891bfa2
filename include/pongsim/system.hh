#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "pongsim/actor.hh"
#include "pongsim/declaration.hh"
#include "pongsim/diagnostic.hh"
#include "pongsim/element.hh"
#include "pongsim/export.hh"
#include "pongsim/handles.hh"
#include "pongsim/log.hh"
#include "pongsim/node.hh"
#include "pongsim/random.hh"
#include "pongsim/state/state_archive.hh"
#include "pongsim/types.hh"
#include "pongsim/world_edits.hh"

namespace pongsim {

/// Time and iteration of a call to a system.
struct StepInfo {
  /// Simulated time at the end of this step.
  Time time{0};
  /// Length of the step; zero while paused.
  Time dt{0};
  /// Steps made, this one included.
  std::uint64_t iteration = 0;
  bool paused = false;
};

class System;

/// What a system is given at its start. All references are valid as long as the system.
struct SystemContext {
  /// The `<plugin>` element, with its parameters below it.
  const Element& sdf;
  World& world;
  /// The model that contains the plugin; nothing for a plugin in the world or in an actor.
  std::optional<Model> model;
  Node& node;
  const Logger& log;
  Random& random;
  /// For warnings about the file. Valid during `configure` only.
  Diagnostics& diagnostics;
  /// The systems listed before this one. Valid during `configure` only.
  std::span<System* const> before;
  /// Inserts and removes models.
  WorldEdits& edits;
  /// The actor that contains the plugin; nothing otherwise.
  std::optional<Actor> actor;
};

/// A system: a part of the simulation that a world's `<plugin>` element asks for. All functions are called on the
/// simulation's thread, for all systems in the order of the file before the next phase begins.
class PONGSIM_API System {
 public:
  virtual ~System();

  /// Describes the system and binds its parameters to members. Called first and once, also without a simulation. The
  /// parameters are then read; if one is invalid, or the `<plugin>` is in the wrong place, the system is left out with
  /// a warning.
  virtual void declare(Declaration&) {}

  /// Finds joints, opens topics and so on. Called once, when all models exist and the parameters are in their members.
  /// @throws Error if something is missing; the system is then left out with a warning.
  virtual void configure(const SystemContext& context) = 0;

  /// Before physics: the place for commands. Messages were delivered just before.
  virtual void preUpdate(const StepInfo&) {}
  /// Before physics, after all systems' `preUpdate`.
  virtual void update(const StepInfo&) {}
  /// After physics: the place for reading the state and publishing.
  virtual void postUpdate(const StepInfo&) {}
  /// The world was reset, including its random numbers. Comes after `worldChanged` if both are called.
  virtual void reset() {}
  /// Models or joints were added or removed. The place for finding new ones and dropping handles that no longer exist:
  /// a system that uses such a handle (`Gone`) is stopped until the next reset. The systems of a removed model are
  /// removed with it; those of a model in an unloaded level are not called until it is loaded again, and then this is
  /// called first.
  virtual void worldChanged() {}
  /// Writes the system's state between steps to `archive`, or reads it back. A system that does not save its state
  /// keeps its current one when a state is restored. The random stream of the context is saved automatically, copies of
  /// it are not (`Random::transfer`). What is read may have been forged: `StateArchive::check` what you rely on.
  virtual void transfer(StateArchive&) {}
  /// The run is over, no step follows (`Simulation::finish`). The place for completing files, since a destructor can't
  /// report that this failed. Also called if the system was switched off.
  /// @throws std::exception if the system's files are not complete; `pongsim run` then exits with code 1.
  virtual void finish() {}
};

/// Version of the interface between system libraries and pongsim. Libraries with another version are not loaded.
inline constexpr std::uint32_t kAbiVersion = 8;

/// A system in a library.
struct SystemEntry {
  /// Class names used by worlds, the preferred one first.
  std::span<const char* const> names;
  System* (*create)();
};

/// Exported by a system library under the name `pongsim_systems`. The version always stays the first member.
struct SystemTable {
  std::uint32_t abiVersion;
  std::span<const SystemEntry> entries;
};

}  // namespace pongsim

/// Exports the system `Class` from its library, under the class names that follow. Use once per library.
#define PONGSIM_EXPORT_SYSTEM(Class, ...)                                                                 \
  extern "C" PONGSIM_API const ::pongsim::SystemTable pongsim_systems;                                    \
  namespace {                                                                                             \
  constexpr const char* kPongsimSystemNames[] = {__VA_ARGS__};                                            \
  constexpr ::pongsim::SystemEntry kPongsimSystemEntries[] = {                                            \
      {kPongsimSystemNames, []() -> ::pongsim::System* { return std::make_unique<Class>().release(); }}}; \
  }                                                                                                       \
  const ::pongsim::SystemTable pongsim_systems { ::pongsim::kAbiVersion, kPongsimSystemEntries }
