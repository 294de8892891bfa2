#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "pongsim/export.hh"
#include "pongsim/handles.hh"
#include "pongsim/message.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// How much of a world's state is told.
enum class StateContent {
  /// All entities with all their components.
  kAll,
  /// What changes from step to step: poses of what is not static, positions and velocities of joints.
  kMoving
};

/// One light of a world.
struct LightPlace {
  LightId id;
  std::string name;
  /// Pose in the frame of the link that holds it, or of the world.
  Pose X_ParentLight;
};

/// What is to be seen in a world, and its state, as messages of Fortress tell it. It must not outlive the `Simulation`.
class PONGSIM_API Scene {
 public:
  explicit Scene(const World& world);

  /// Fills in an `ignition.msgs.Scene`: models with their links, visuals, lights and sensors, and the lights of the
  /// world, all where they are now, in the frame of what holds them.
  /// @param isWanted Told the id of each model at the top level and each light of the world. Empty: all are.
  void fillIn(Message& scene, const std::function<bool(std::uint64_t)>& isWanted = {}) const;

  /// Fills in an `ignition.msgs.SerializedStepMap`: the state, and of the statistics the simulated time, the iterations
  /// and whether the world is paused.
  void fillInState(Message& step, StateContent content, bool isPaused) const;

  /// @return Who holds whom, as text for Graphviz.
  std::string graph() const;

  /// @return All lights, those of links too, in the order of their ids.
  std::vector<LightPlace> lights() const;

  /// @return The ids of the models at the top level and of the lights of the world, in ascending order.
  std::vector<std::uint64_t> topLevelIds() const;

 private:
  friend class StatePlayer;
  friend class StateWatch;
  sim::Access* access_;
};

}  // namespace pongsim
