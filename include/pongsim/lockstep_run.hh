#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pongsim/export.hh"
#include "pongsim/node.hh"
#include "pongsim/outcome.hh"
#include "pongsim/simulation.hh"

namespace pongsim {

/// What a simulation in lockstep waits for.
struct LockstepOptions {
  /// A topic of a controller.
  struct Topic {
    std::string name;
    /// After each so many steps, the world waits for the topic.
    std::uint64_t every = 1;
    /// So many messages.
    std::uint64_t count = 1;
  };
  /// At least one.
  std::vector<Topic> topics;
  /// Before the first step, the world waits until somebody outside subscribes to each of these; empty: to any topic,
  /// or until a message waits on each of `topics`.
  std::vector<std::string> heard;
  /// Longest wait, of wall time.
  std::optional<std::chrono::nanoseconds> timeout = std::nullopt;
  /// Whether the run goes on after that, instead of ending.
  bool goesOnWhenLate = false;
};

/// @param text TOPIC[:EVERY[:COUNT]]. A name may have colons itself.
/// @return The topic, or what is wrong with it.
PONGSIM_API Outcome<LockstepOptions::Topic> lockstepTopic(std::string_view text);

/// @param node Of the world.
/// @return A sentence for each topic that no system of the world subscribes to or, of those that must be heard,
/// publishes on; with the nearest name.
PONGSIM_API std::vector<std::string> unknownLockstepTopics(const LockstepOptions& options, const Node& node);

/// Steps a simulation in lockstep with controllers in other processes, as `pongsim run --lockstep` does; for programs
/// that step a simulation themselves. What comes from outside is held as soon as this exists, so make it before the
/// first dispatch.
class PONGSIM_API LockstepRun {
 public:
  /// @param simulation Must outlive this.
  /// @throws std::invalid_argument for an invalid topic name.
  LockstepRun(Simulation& simulation, LockstepOptions options);
  ~LockstepRun();
  LockstepRun(const LockstepRun&) = delete;
  LockstepRun& operator=(const LockstepRun&) = delete;

  /// Waits for the messages that are due, and then makes a step. Before the first one it waits for the controllers.
  /// @param goesOn Asked before the step and, several times a second, while it waits: false ends the wait.
  /// @return Whether the step was made; or who is late, which ends the run.
  /// @throws What a step throws.
  Outcome<bool> step(const std::function<bool()>& goesOn);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace pongsim
