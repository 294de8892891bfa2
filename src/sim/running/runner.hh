#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "pongsim/outcome.hh"
#include "pongsim/simulation.hh"
#include "sim/inputs/run_observer.hh"
#include "sim/resource_services.hh"
#include "sim/running/lockstep.hh"

namespace pongsim::sim {

struct RunOptions {
  /// Starts paused.
  bool paused = false;
  /// Ends the run after this many steps.
  std::optional<std::uint64_t> iterations = std::nullopt;
  /// Steps per second of wall time, instead of the world's `<real_time_factor>`. 0: as fast as possible.
  std::optional<double> updateRate = std::nullopt;
  /// Called after each step, on its thread; may be empty. If it returns false, the run ends.
  std::function<bool(Simulation&)> stepped = {};
  /// Makes what is told of each step of a world, before the first; may be empty.
  std::function<std::unique_ptr<RunObserver>(Simulation&)> observe = {};
  /// Whether and how it waits for controllers.
  std::optional<LockstepOptions> lockstep = std::nullopt;
};

/// Steps a simulation at the pace of the wall clock, publishes its status on `/world/W/clock`, `/world/W/stats` and,
/// for the first world of a process, `/clock` and `/stats`, and offers the services that control it
/// (`/world/W/control`).
class Runner {
 public:
  /// All references must outlive this.
  /// @param folderAdded Called within `run` with resource folders added by requests; empty: not the first world.
  /// @throws std::invalid_argument if another run offers the services on the simulation's transport.
  Runner(
      Simulation& simulation, const RunOptions& options,
      ResourceServices::FolderAdded folderAdded = [](const auto&) {});
  ~Runner();

  /// Runs on the calling thread until all steps are made or `stop` is called.
  void run();

  /// @return Why the run could not go on, if so.
  Outcome<void> outcome() const { return outcome_; }

  /// Ends the run's topics and services. To be called after `run`.
  void leave();

  /// Queues `task`, which `run` calls between two steps. Thread-safe.
  void post(std::function<void(Simulation&)> task);
  /// Adds a resource folder between two steps. Thread-safe.
  void addFolder(const std::filesystem::path& folder);

  /// Makes `run` end soon. Thread-safe and lock-free, so it may be called from a signal handler.
  void stop() { stopping_.store(true); }

 private:
  bool isOver() const;
  void doTasks();
  void dispatched();
  void served();
  void advance(Time dt);
  void waitPaused();
  bool takeIn();
  void runSteps();

  struct Parts;
  std::unique_ptr<Parts> parts_;
  Outcome<void> outcome_;
  std::atomic<bool> stopping_{false};
  std::atomic<bool> hasTasks_{false};
  std::mutex tasksMutex_;
  std::vector<std::function<void(Simulation&)>> tasks_;
};

}  // namespace pongsim::sim
