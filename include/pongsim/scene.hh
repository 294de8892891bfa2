#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "pongsim/export.hh"
#include "pongsim/handles.hh"
#include "pongsim/message.hh"
#include "pongsim/outcome.hh"
#include "pongsim/semantics.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// Which part of a world's state to include.
enum class StateContent {
  /// All entities with all components.
  kAll,
  /// What changes from step to step: poses of entities that are not static, positions and velocities of joints.
  kMoving
};

/// A light of a world.
struct LightPlace {
  LightId id;
  std::string name;
  /// Pose in the frame of its link, or of the world.
  Pose X_ParentLight;
};

/// An actor of a world.
struct ActorPlace {
  ActorId id;
  std::string name;
  /// Path of its skin's file, or its URI in the file if that was not found; empty: none.
  std::string skin;
};

using EmitterId = Id<struct EmitterKind>;

/// A particle emitter of a world.
struct EmitterPlace {
  EmitterId id;
  std::string name;
  LinkId link;
  /// As in its file; empty: not given.
  std::string topic;
};

/// A world's scene and state as Fortress's messages. Must not outlive the `Simulation`.
class PONGSIM_API Scene {
 public:
  explicit Scene(const World& world);

  /// Fills in an `ignition.msgs.Scene`: models with links, visuals, lights and sensors, and the lights of the world, at
  /// their current poses in their parents' frames.
  /// @param isWanted Called with the id of each top-level model and light; empty: all are included.
  void fillIn(Message& scene, const std::function<bool(std::uint64_t)>& isWanted = {}) const;

  /// Fills in an `ignition.msgs.SerializedStepMap`: the state, and simulated time, iterations and pause in its
  /// statistics.
  void fillInState(Message& step, StateContent content, bool isPaused) const;

  /// Fills in an `ignition.msgs.GUI`: the plugins in `<gui>` of the world's file.
  void fillInGui(Message& gui) const;

  /// @return The tree of entities as text for Graphviz.
  std::string graph() const;

  /// @return All lights, including those of links, in the order of their ids.
  std::vector<LightPlace> lights() const;

  /// @return All actors, in the order of the file.
  std::vector<ActorPlace> actors() const;

  /// @return The particle emitters that are in loaded levels, in the order of their links. Cameras see what they emit,
  /// and it scatters the light of lidars and depth cameras.
  std::vector<EmitterPlace> emitters() const;

  /// Fills in an `ignition.msgs.ParticleEmitter` with its present values; its pose is in the frame of its link.
  /// @throws Gone if it does not exist any more.
  void fillInEmitter(EmitterId id, Message& emitter) const;

  /// Changes what an `ignition.msgs.ParticleEmitter` sets, except name and pose. Images that it names are not read:
  /// they count only if they are those that the emitter has.
  /// @return Why it can't: there is no such emitter, or a value is invalid.
  Outcome<void> changeEmitter(EmitterId id, const Message& emitter);

  /// @return What the file says that the model stands for. The model must exist.
  const Semantics& semantics(ModelId model) const;

  /// @return A number that changes with the colours of visuals (`PhysicalProperties::setColors`).
  std::uint64_t colorChanges() const;

  /// @return The ids of top-level models and lights, in ascending order.
  std::vector<std::uint64_t> topLevelIds() const;

 private:
  friend class MarkerServices;
  friend class StatePlayer;
  friend class StateWatch;
  sim::Access* access_;
};

}  // namespace pongsim
