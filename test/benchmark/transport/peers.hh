#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "support/process.hh"

namespace pongsim::benchmark {

inline constexpr const char* kTopic = "/measured";
inline constexpr const char* kFloodTopic = "/flood";

/// The other processes' main functions.
/// Receives `count` messages of a kind, or as many as come, takes `pause` [ms] for each and prints how old they were.
int listen(const std::string& library, int kind, std::size_t count, int pause);
/// Publishes 100,000 messages a second.
int flood();
/// Starts listeners and kills one after another until SIGTERM. Its own process, since a process that forks copies each
/// page that it writes to afterwards.
int killListeners();

/// Starts a process that calls `listen`, and waits until it is ready.
std::unique_ptr<test::Process> listener(const char* library, int kind, int count, int pause = 0);
/// Starts a process with this program's command `flood` or `kill`, and waits until it is ready.
std::unique_ptr<test::Process> other(const char* command);
/// @return What a listener has printed, once it has ended.
std::string reportOf(test::Process& process);

}  // namespace pongsim::benchmark
