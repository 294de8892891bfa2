#pragma once

#include "fuel/failure.hh"
#include "shared/program/stop_signal.hh"

namespace pongsim::fuel {

/// @throws Interrupted if a signal requested to stop; the caller cleans up.
inline void checkInterruption() {
  if (cli::isStopped()) throw Interrupted();
}

}  // namespace pongsim::fuel
