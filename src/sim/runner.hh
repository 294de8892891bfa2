#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "pongsim/simulation.hh"
#include "sim/resource_services.hh"

namespace pongsim::sim {

struct RunOptions {
  /// Begin paused.
  bool paused = false;
  /// End after that many steps.
  std::optional<std::uint64_t> iterations = std::nullopt;
  /// Steps a second of wall time; instead of the world's `<real_time_factor>`. 0: as many as possible.
  std::optional<double> updateRate = std::nullopt;
  /// Called after each step, on its thread; may be empty. Where it returns false the run ends.
  std::function<bool(Simulation&)> stepped = {};
};

/// Steps a simulation at the pace of the wall clock, and tells on its topics (`/world/W/clock`, `/world/W/stats`, and
/// for the first world of a process `/clock`, `/stats`) where it stands. Pauses and steps as its services
/// (`/world/W/control`) are asked to.
class Runner {
 public:
  /// All references must outlive it.
  /// @param folderAdded Told of resource folders that others add, from within `run`; empty: it is not the first world.
  /// @throws std::invalid_argument where another run offers the services on the simulation's transport.
  Runner(
      Simulation& simulation, const RunOptions& options,
      ResourceServices::FolderAdded folderAdded = [](const auto&) {});
  ~Runner();

  /// Runs until the steps are done or `stop` was called.
  void run();

  /// Ends its topics and services, after `run`.
  void leave();

  /// Has `task` called between two steps, from within `run`. May be called from any thread.
  void post(std::function<void(Simulation&)> task);

  /// Ends `run` soon. May be called from any thread and, being lock-free, from a signal handler.
  void stop() { stopping_.store(true); }

 private:
  bool isOver() const;
  void doTasks();
  void waitPaused();
  void runSteps();

  struct Parts;
  std::unique_ptr<Parts> parts_;
  std::atomic<bool> stopping_{false};
  std::atomic<bool> hasTasks_{false};
  std::mutex tasksMutex_;
  std::vector<std::function<void(Simulation&)>> tasks_;
};

}  // namespace pongsim::sim
