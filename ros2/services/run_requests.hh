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

/// Pauses, steps, resets and ends a run as simulation_interfaces has it, by the services that the run itself offers.
/// The simulation's state is
///
/// - stopped: paused at the very start, or after a reset;
/// - paused: paused after a step, or since "paused" was asked for;
/// - playing: all else, the steps of a step request too.
class RunRequests {
 public:
  using Done = std::function<void(const Result&)>;
  using State = simulation_interfaces::SimulationState;

  RunRequests(const Node& simulation, const ServiceNames& names);

  /// @return Whether somebody runs the simulation who can be asked; not where a program steps it by itself.
  bool canBeAsked();

  /// To be called first in each step.
  void preUpdate(const StepInfo& info);
  /// The world was reset.
  void worldReset();

  std::uint8_t state() const;

  /// @param target One of `State`'s.
  /// @param done Called once, maybe at once, likewise below.
  void setState(std::uint8_t target, Done done);
  /// Makes so many steps where the run is paused. One request at a time.
  void step(std::uint64_t count, Done done);
  /// Sets the whole world back to its start. It goes on, or not, as before.
  /// @param isStepped Whether somebody else makes steps of a paused run now, which it is again then.
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
