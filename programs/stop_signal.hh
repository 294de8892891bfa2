#pragma once

namespace pongsim::programs {

/// From now on SIGINT, SIGTERM and SIGHUP are a wish to end; a second one ends the process.
void takeStopSignals();

/// @return Whether one has come. From any thread.
bool isStopped();

}  // namespace pongsim::programs
