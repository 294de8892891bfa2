#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "pongsim/node.hh"
#include "pongsim/system.hh"
#include "ros2/node/action.hh"
#include "ros2/types/simulation_actions.hh"

namespace pongsim::ros2 {

/// The action SimulateSteps of simulation_interfaces: makes a paused simulation run a number of steps, with feedback
/// after each, and pauses it again. Uses the run's own service `/world/W/control`. Only one goal at a time: a second
/// one finds the simulation not paused.
class SimulateSteps {
 public:
  using Action = simulation_interfaces::action::SimulateSteps;

  /// @param simulation Must have access to the world's services.
  /// @param control The service that steps the world: "/world/W/control".
  /// @param name Of the action: "~/simulate_steps".
  SimulateSteps(const Node& simulation, const std::string& control, RosNode& ros, const std::string& name);

  /// @return Whether a goal is executing.
  bool isRunning() const { return running_.has_value(); }

  /// Call like a system's functions; `preUpdate` before the mailbox is dispatched.
  void preUpdate(const StepInfo& info);
  void postUpdate(const StepInfo& info);
  void reset();

 private:
  struct Running {
    Goals::Id id;
    std::uint64_t steps = 0;
    /// Number of steps before the goal.
    std::uint64_t first = 0;
    std::uint64_t completed = 0;
    /// Number of steps requested so far, not counting `first`.
    std::uint64_t requested = 0;
    /// Whether the run has accepted the request: from then on a pause means the end.
    bool isTaken = false;
    bool isStopping = false;
  };

  void start(const Goals::Id& id, std::uint64_t steps);
  void askForSteps();
  void stop();
  /// Ends the executing goal.
  void end(std::int8_t status, std::uint8_t code, const std::string& message);
  std::string progress() const;

  Node simulation_;
  std::string control_;
  StepInfo info_;
  ActionServer<Action> server_;
  std::optional<Running> running_;
  // destroyed first, because its answer uses the other members
  PendingRequest request_;
};

}  // namespace pongsim::ros2
