#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>

#include "pongsim/simulation.hh"

namespace pongsim::sim {

struct RunOptions {
  /// Begin paused.
  bool paused = false;
  /// End after that many steps.
  std::optional<std::uint64_t> iterations = std::nullopt;
  /// Steps a second of wall time; instead of the world's `<real_time_factor>`. 0: as many as possible.
  std::optional<double> updateRate = std::nullopt;
};

/// Steps a simulation at the pace of the wall clock, and tells on its topics (`/clock`, `/stats`,
/// `/world/W/clock`, `/world/W/stats`) where it stands. Pauses, steps and ends as its services (`/world/W/control`,
/// `/server_control`) are asked to.
class Runner {
 public:
  /// All references must outlive it.
  /// @throws std::invalid_argument where another run offers the services on the simulation's transport.
  Runner(Simulation& simulation, const RunOptions& options);
  ~Runner();

  /// Runs until the steps are done or `stop` was called.
  void run();

  /// Ends `run` soon. May be called from any thread and, being lock-free, from a signal handler.
  void stop() { stopping_.store(true); }

 private:
  bool isOver() const;
  void waitPaused();
  void runSteps();

  struct Parts;
  std::unique_ptr<Parts> parts_;
  std::atomic<bool> stopping_{false};
};

}  // namespace pongsim::sim
