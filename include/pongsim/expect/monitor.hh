#pragma once

#include <cstddef>
#include <memory>

#include "pongsim/expect/expectation.hh"
#include "pongsim/export.hh"
#include "pongsim/outcome.hh"
#include "pongsim/simulation.hh"

namespace pongsim {

/// Watches a simulation and judges what is expected of it. Poses, velocities, joints and contacts are looked at before
/// the first step and after each, messages when they arrive, at the time at which they were published. It changes
/// nothing, but its subscriptions count as ones. Use it on the simulation's thread; must not outlive it.
class PONGSIM_API Monitor {
 public:
  explicit Monitor(Simulation& simulation);
  ~Monitor();
  Monitor(const Monitor&) = delete;
  Monitor& operator=(const Monitor&) = delete;

  /// Adds an expectation; what happened before does not count for it, but its times are those of the simulation.
  /// @return Its number, from 0; or why it can't be watched: an unknown model, joint, or field, with the nearest name.
  Outcome<std::size_t> add(Expectation expectation);

  /// Makes steps until the time is at least `end`, or an expectation is decided. `goesOn` is asked before each step.
  /// @return Whether one was decided.
  /// @throws What a step throws.
  template <class GoesOn>
  bool runUntil(Time end, GoesOn goesOn) {
    return runUntil(end, goesOn, [this] { simulation_->step(); });
  }
  /// The same with a function that makes a step.
  template <class GoesOn, class Step>
  bool runUntil(Time end, GoesOn goesOn, Step step) {
    const std::size_t before = decided();
    begin();
    while (decided() == before && simulation_->time() < end && goesOn()) {
      step();
      look();
    }
    return decided() != before;
  }
  bool runUntil(Time end) {
    return runUntil(end, [] { return true; });
  }

  /// Looks at the world after a step: for programs that step the simulation themselves.
  void look();

  /// Judges what is not decided yet, because the run is over: delivers the messages of the last step first.
  void finish();

  /// @return The number of expectations that are decided.
  std::size_t decided() const;

  /// @param number Of an expectation, as returned by `add`.
  Verdict verdict(std::size_t number) const;

 private:
  struct Parts;
  void begin();
  Simulation* simulation_;
  std::unique_ptr<Parts> parts_;
};

}  // namespace pongsim
