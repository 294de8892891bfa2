#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "pongsim/system.hh"
#include "ros2/services/requests.hh"
#include "ros2/services/result.hh"
#include "ros2/services/service_names.hh"
#include "ros2/types/simulation_world_services.hh"

namespace pongsim::ros2 {

/// Pauses, steps, resets and ends a run for simulation_interfaces, through the run's own services. The simulation's
/// state is
///
/// - stopped: paused at the very start, or after a reset;
/// - paused: paused after a step, or since "paused" was requested;
/// - playing: otherwise, including during the steps of a step request.
class RunRequests {
 public:
  using Done = std::function<void(const Result&)>;
  using State = simulation_interfaces::SimulationState;

  RunRequests(const Node& simulation, const ServiceNames& names);

  /// @return Whether the simulation is run by something that accepts requests; false if a program steps it itself.
  bool canBeAsked();

  /// Call first in each step.
  void preUpdate(const StepInfo& info);
  /// Call after a reset of the world.
  void worldReset();

  std::uint8_t state() const;

  /// @param target One of `State`'s.
  /// @param done Called once, possibly before this returns; the same below.
  void setState(std::uint8_t target, Done done);
  /// Runs a number of steps if the run is paused. One request at a time.
  void step(std::uint64_t count, Done done);
  /// Resets the whole world. The run continues, or stays paused, as before.
  /// @param isStepped Whether something else is stepping the paused run, which is then paused again.
  void resetAll(bool isStepped, Done done);

 private:
  struct Stepping {
    std::uint64_t first;
    std::uint64_t count;
    Done done;
    bool isAnswered = false;
  };
  struct Control {
    bool pause = false;
    std::uint64_t steps = 0;
    bool reset = false;
  };

  void control(const Control& what, std::uint8_t errorCode, Done done);
  void lookAtSteps();
  void endSteps(const Result& result);

  Requests requests_;
  ServiceNames names_;
  Node node_;
  StepInfo info_;
  bool isStartPaused_ = false;
  std::optional<Stepping> stepping_;
};

}  // namespace pongsim::ros2
