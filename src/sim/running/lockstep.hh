#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/lockstep_run.hh"
#include "pongsim/log.hh"
#include "pongsim/outcome.hh"
#include "pongsim/simulation.hh"
#include "transport/gate.hh"

namespace pongsim::sim {

/// Lets a simulation wait for its controllers: before the first step until they are there, and after each `every` steps
/// for their messages. `transport::Gate` says what is taken in when.
class Lockstep {
 public:
  /// Messages that may wait on a topic; more come from a controller that sends more than a tick takes.
  static constexpr std::size_t kMostAhead = 500;

  /// @param simulation Must outlive this.
  Lockstep(Simulation& simulation, LockstepOptions options);

  struct Run {
    /// Does what is to be done between steps; @return Whether the run goes on: neither paused nor over.
    std::function<bool()> goesOn;
    /// Calls the systems without a step.
    std::function<void()> callSystems;
    /// Told that messages and requests were handed over, or only requests.
    std::function<void()> dispatched = [] {};
    std::function<void()> served = [] {};
  };

  /// Dispatches before a step, after waiting for what is due. Meanwhile requests are handled.
  /// @return Whether the step can be made; nothing was taken in if the run does not go on. An error ends the run.
  Outcome<bool> takeIn(const Run& run);

  /// Must be called while the run is paused: requests are then handled whenever they come.
  void pause() { gate_.setPaused(true); }

 private:
  using Clock = std::chrono::steady_clock;

  /// A wait, for one step.
  struct Wait {
    std::uint64_t step;
    Clock::time_point begin = Clock::now();
    bool isReported = false;
    /// Before the first step: since when everybody is there.
    std::optional<Clock::time_point> isThereSince = std::nullopt;
  };

  bool isDue(std::uint64_t step) const;
  void want(std::uint64_t step);
  void settleLate();
  bool isReady(Wait& wait) const;
  void waitOnce(const Wait& wait, const Run& run);
  /// @return Whether the wait is over, because it took too long.
  Outcome<bool> checkTime(Wait& wait);
  Outcome<bool> pass(std::uint64_t step, const Run& run);
  void serve(const Run& run);
  bool areAllSending() const;
  std::string lacking(std::uint64_t step) const;

  Simulation& simulation_;
  const LockstepOptions options_;
  Logger log_{"lockstep"};
  transport::Gate gate_;
  /// The step for which all was taken in.
  std::optional<std::uint64_t> passed_;
  /// For each topic, the messages that the next step waits for, and those that were due before and are late.
  std::vector<std::uint64_t> wanted_;
  std::vector<std::uint64_t> late_;
};

}  // namespace pongsim::sim
