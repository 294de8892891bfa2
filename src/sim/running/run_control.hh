#pragma once

#include <cstdint>
#include <optional>

#include "msgs/control/control_messages.hh"
#include "pongsim/outcome.hh"
#include "pongsim/types.hh"

namespace pongsim::sim {

/// Whether a run steps or is paused, and until when, as with Fortress's `/world/W/control`.
class RunControl {
 public:
  explicit RunControl(bool paused) : paused_(paused) {}

  /// Applies a request between two steps. Without `pause` the run continues, whatever else is requested. Several steps
  /// and a time to run to only apply with `pause` true and false, respectively; a time in the past is ignored. After a
  /// reset without `pause` during several steps, the run pauses after the remaining ones, of which, as in Fortress, the
  /// start itself is one.
  /// @param now Time after the reset, if one is requested; the reset itself is up to the caller.
  Outcome<void> apply(const msgs::WorldControl& asked, Time now);

  /// Reports that a step was made, and the time.
  void stepped(Time now);

  /// @return Whether to make no step now.
  bool paused() const { return paused_ && stepsLeft_ == 0; }

 private:
  bool paused_;
  /// Until the pause.
  std::uint32_t stepsLeft_ = 0;
  std::optional<Time> runTo_;
};

}  // namespace pongsim::sim
