#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "msgs/control_messages.hh"
#include "pongsim/types.hh"

namespace pongsim::sim {

/// Whether a run steps or is paused, and when that changes; as `/world/W/control` of Fortress has it.
class RunControl {
 public:
  explicit RunControl(bool paused) : paused_(paused) {}

  /// Takes a request in between two steps. Without `pause` the run goes on, whatever else is asked for. Several steps
  /// and a time to run to count only with `pause` true and false, respectively; a time that has passed does not count.
  /// A reset without `pause` among several steps lets the run pause behind those that are left, of which, as with
  /// Fortress, the start itself is one.
  /// @param now After the reset, where one is asked for, which is for the caller to do.
  /// @return Why nothing of it was done, or nothing.
  std::optional<std::string> apply(const msgs::WorldControl& asked, Time now);

  /// Tells of a step that has been made, and what time it is now.
  void stepped(Time now);

  /// @return Whether no step is to be made now.
  bool paused() const { return paused_ && stepsLeft_ == 0; }

 private:
  bool paused_;
  /// Before the pause.
  std::uint32_t stepsLeft_ = 0;
  std::optional<Time> runTo_;
};

}  // namespace pongsim::sim
