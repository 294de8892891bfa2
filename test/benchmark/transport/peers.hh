#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "support/process.hh"

namespace pongsim::benchmark {

inline constexpr const char* kTopic = "/measured";
inline constexpr const char* kFloodTopic = "/flood";

/// The other processes' main functions.
/// Receives up to `count` messages of a kind, pauses for `pause` [ms] after each, and prints their ages.
int listen(const std::string& library, int kind, std::size_t count, int pause);
/// Publishes 100,000 messages a second.
int flood();
/// Starts listeners and kills one after another until SIGTERM. A process of its own, because forking makes later writes
/// of the forking process slower (copy on write).
int killListeners();

/// Starts a process that calls `listen`, and waits until it is ready.
std::unique_ptr<test::Process> listener(const char* library, int kind, int count, int pause = 0);
/// Starts a process with this program's command `flood` or `kill`, and waits until it is ready.
std::unique_ptr<test::Process> other(const char* command);
/// @return The output of a listener, after waiting for its end.
std::string reportOf(test::Process& process);

}  // namespace pongsim::benchmark
