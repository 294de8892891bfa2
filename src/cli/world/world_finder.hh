#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace pongsim {
class Transport;
}

namespace pongsim::cli {

class StopSignal;

enum class WorldChoice {
  /// None: this is an error.
  kOnly,
  /// The first one of the process that runs them, as in Fortress's `ign model`; an error if there are several
  /// processes.
  kFirst
};

/// Finds the world that a user means, by its `/world/W/control`. Reports failures.
/// @param wanted Its name; empty: the only running one.
/// @param timeout How long to wait for it.
/// @param choice Which one to take if no name is given and several are running.
/// @return Its name as used in topics.
std::optional<std::string> findWorld(Transport& transport, const StopSignal& signal, const std::string& wanted,
                                     std::chrono::nanoseconds timeout, WorldChoice choice = WorldChoice::kOnly);

}  // namespace pongsim::cli
