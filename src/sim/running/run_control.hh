#pragma once

#include <cstdint>
#include <optional>

#include "msgs/control/control_messages.hh"
#include "pongsim/outcome.hh"
#include "pongsim/types.hh"

namespace pongsim::sim {

/// Whether a run steps or is paused, and when it pauses; the semantics of Fortress's service `/world/W/control`.
class RunControl {
 public:
  explicit RunControl(bool paused) : paused_(paused) {}

  /// Applies a request between two steps. Without `pause` in it, the run continues, whatever else is requested.
  /// `multi_step` applies only with `pause: true`, and `run_to_sim_time` only with `pause: false`; a time in the past
  /// is ignored. After a reset without `pause` during a `multi_step`, the run pauses after the remaining steps; as in
  /// Fortress, the reset counts as one of them.
  /// @param now Time after the reset, if one is requested; the reset itself is up to the caller.
  Outcome<void> apply(const msgs::WorldControl& asked, Time now);

  /// To be called after each step.
  /// @param now Simulated time.
  void stepped(Time now);

  /// @return Whether the run is paused: no step is to be made now.
  bool paused() const { return paused_ && stepsLeft_ == 0; }

 private:
  bool paused_;
  /// Number of steps until the run pauses.
  std::uint32_t stepsLeft_ = 0;
  std::optional<Time> runTo_;
};

}  // namespace pongsim::sim
