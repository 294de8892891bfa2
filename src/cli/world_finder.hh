#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace pongsim {
class Transport;
}

namespace pongsim::cli {

class StopSignal;

/// Finds the world that a user means, by its `/world/W/control`. Says why where it can't.
/// @param wanted Its name; empty: the only one that runs.
/// @param timeout How long to wait for it.
/// @return Its name as it stands in topics.
std::optional<std::string> findWorld(Transport& transport, const StopSignal& signal, const std::string& wanted,
                                     std::chrono::nanoseconds timeout);

}  // namespace pongsim::cli
