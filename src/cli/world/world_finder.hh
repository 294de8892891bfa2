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
  /// None: it is an error.
  kOnly,
  /// The first one of the process that runs them, as for Fortress's `ign model`; an error where several processes do.
  kFirst
};

/// Finds the world that a user means, by its `/world/W/control`. Says why where it can't.
/// @param wanted Its name; empty: the only one that runs.
/// @param timeout How long to wait for it.
/// @param choice Which one is meant without a name, where several run.
/// @return Its name as it stands in topics.
std::optional<std::string> findWorld(Transport& transport, const StopSignal& signal, const std::string& wanted,
                                     std::chrono::nanoseconds timeout, WorldChoice choice = WorldChoice::kOnly);

}  // namespace pongsim::cli
