#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "pongsim/node.hh"
#include "pongsim/system.hh"
#include "ros2/node/action.hh"
#include "ros2/types/simulation_actions.hh"

namespace pongsim::ros2 {

/// The action SimulateSteps of simulation_interfaces: a paused simulation makes so many steps, with feedback after
/// each, and is paused again. It asks the run for them by the service `/world/W/control`, as anybody would. One goal at
/// a time: a second one finds the simulation not paused.
class SimulateSteps {
 public:
  using Action = simulation_interfaces::action::SimulateSteps;

  /// @param simulation Must have the world's services in its transport.
  /// @param control The service that steps the world: "/world/W/control".
  /// @param name Of the action: "~/simulate_steps".
  SimulateSteps(const Node& simulation, const std::string& control, RosNode& ros, const std::string& name);

  /// @return Whether a goal makes its steps.
  bool isRunning() const { return running_.has_value(); }

  /// As the system's; `preUpdate` before the mailbox is dispatched.
  void preUpdate(const StepInfo& info);
  void postUpdate(const StepInfo& info);
  void reset();

 private:
  struct Running {
    Goals::Id id;
    std::uint64_t steps = 0;
    /// Steps made before.
    std::uint64_t first = 0;
    std::uint64_t completed = 0;
    /// Steps asked for so far, `first` not counted.
    std::uint64_t asked = 0;
    /// Whether the run has taken what was asked for: from then on a pause is an end.
    bool isTaken = false;
    bool isStopping = false;
  };

  void start(const Goals::Id& id, std::uint64_t steps);
  void askForSteps();
  void stop();
  /// Ends the goal that runs.
  void end(std::int8_t status, std::uint8_t code, const std::string& message);
  std::string progress() const;

  Node simulation_;
  std::string control_;
  StepInfo info_;
  ActionServer<Action> server_;
  std::optional<Running> running_;
  // ends first, for its answer goes to the rest
  PendingRequest request_;
};

}  // namespace pongsim::ros2
