#pragma once

namespace pongsim::log {

/// From now on SIGINT, SIGTERM and SIGHUP are a wish to end; a second one ends the process.
void takeStopSignals();

/// @return Whether one has come.
bool isStopped();

}  // namespace pongsim::log
