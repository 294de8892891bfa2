#pragma once

#include "fuel/failure.hh"
#include "shared/program/stop_signal.hh"

namespace pongsim::fuel {

/// @throws Interrupted if SIGINT, SIGTERM or SIGHUP has arrived. The caller cleans up.
inline void checkInterruption() {
  if (cli::isStopped()) throw Interrupted();
}

}  // namespace pongsim::fuel
