#pragma once

namespace pongsim::cli {

/// From now on SIGINT, SIGTERM and SIGHUP are requests to stop; a second one ends the process.
void takeStopSignals();

/// @return Whether a stop was requested. For any thread.
bool isStopped();

}  // namespace pongsim::cli
