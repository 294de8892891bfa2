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
#include "pongsim/state_archive.hh"
#include "pongsim/types.hh"
#include "pongsim/world_edits.hh"

namespace pongsim {

/// Where a run stands when a system is called.
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

/// What a system is given when it starts. All references live as long as the system.
struct SystemContext {
  /// The `<plugin>` element, with its parameters below it.
  const Element& sdf;
  World& world;
  /// The model that the plugin stands in; nothing where it stands in the world or in an actor.
  std::optional<Model> model;
  Node& node;
  const Logger& log;
  Random& random;
  /// For what is wrong with the file and does no harm. There during `configure` only.
  Diagnostics& diagnostics;
  /// The systems that the file names before this one. There during `configure` only.
  std::span<System* const> before;
  /// How it inserts and removes models.
  WorldEdits& edits;
  /// The actor that the plugin stands in, if it does in one.
  std::optional<Actor> actor;
};

/// A part of the simulation that a world's `<plugin>` element asks for. All functions are called on the
/// simulation's thread: the systems in the order of the file, each phase through all of them before the next.
class PONGSIM_API System {
 public:
  virtual ~System();

  /// Says what the system is, and binds its parameters to members. Called once and first, also where nothing is
  /// simulated. The parameters are read then; where one can't be used, or the `<plugin>` stands in the wrong place, the
  /// system is left out with a warning.
  virtual void declare(Declaration&) {}

  /// Finds the joints, topics and so on. Called once, with all models there, the parameters in their members.
  /// @throws Error for what can't be had; the system is then left out with a warning.
  virtual void configure(const SystemContext& context) = 0;

  /// Before the physics: the place for commands. Messages have been handed over just before.
  virtual void preUpdate(const StepInfo&) {}
  /// Before the physics and after every system's `preUpdate`.
  virtual void update(const StepInfo&) {}
  /// After the physics: the place to read the state and to publish.
  virtual void postUpdate(const StepInfo&) {}
  /// The world was set back to its start, its random numbers too. Comes after `worldChanged` where both do.
  virtual void reset() {}
  /// Models or joints have come or gone. The place to look for what is new, and to let go of handles whose `exists`
  /// says no: a system that asks them for more (`Gone`) rests until the next reset. The systems of a model that is
  /// removed go with it and are not called; those of one that is set aside with its level are called again, with this
  /// first, when it is back.
  virtual void worldChanged() {}
  /// Takes what the system remembers from step to step into `archive`, or gives it back from there. One that remembers
  /// something and does not tell it goes on as it is where a state is restored. The random stream of its context needs
  /// not be told, copies of it do (`Random::transfer`).
  virtual void transfer(StateArchive&) {}
};

/// Version of what a system library and pongsim agree on. A library with another one is not loaded.
inline constexpr std::uint32_t kAbiVersion = 6;

/// One system of a library.
struct SystemEntry {
  /// Class names that worlds use, the preferred one first.
  std::span<const char* const> names;
  System* (*create)();
};

/// What a system library exports, under the name `pongsim_systems`. The version stands first, for good.
struct SystemTable {
  std::uint32_t abiVersion;
  std::span<const SystemEntry> entries;
};

}  // namespace pongsim

/// Exports the system `Class` from its library, under the class names that follow. Once a library.
#define PONGSIM_EXPORT_SYSTEM(Class, ...)                                                                 \
  extern "C" PONGSIM_API const ::pongsim::SystemTable pongsim_systems;                                    \
  namespace {                                                                                             \
  constexpr const char* kPongsimSystemNames[] = {__VA_ARGS__};                                            \
  constexpr ::pongsim::SystemEntry kPongsimSystemEntries[] = {                                            \
      {kPongsimSystemNames, []() -> ::pongsim::System* { return std::make_unique<Class>().release(); }}}; \
  }                                                                                                       \
  const ::pongsim::SystemTable pongsim_systems { ::pongsim::kAbiVersion, kPongsimSystemEntries }
