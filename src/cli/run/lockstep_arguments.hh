#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/running/lockstep.hh"

namespace CLI {
class App;
}

namespace pongsim {
class Node;
}

namespace pongsim::cli {

/// @param text TOPIC[:EVERY[:COUNT]]. A name may have colons itself.
/// @throws UsageError if it is none.
sim::LockstepOptions::Topic lockstepTopic(std::string_view text);

/// The options `--lockstep` and those that belong to it.
class LockstepArguments {
 public:
  void addTo(CLI::App& run);

  /// @return What they ask for, if they do.
  /// @throws UsageError where one needs another.
  std::optional<sim::LockstepOptions> check() const;

 private:
  sim::LockstepOptions options_;
  /// An option that has an effect only with `--lockstep`, or empty.
  std::string dependent_;
};

/// @param node Of the world.
/// @return A sentence for each topic that no system of the world subscribes to or, of those that must be heard,
/// publishes on; with the nearest name.
std::vector<std::string> unknownTopics(const sim::LockstepOptions& options, const Node& node);

}  // namespace pongsim::cli
