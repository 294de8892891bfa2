#pragma once

#include "fuel/failure.hh"
#include "programs/stop_signal.hh"

namespace pongsim::fuel {

/// @throws Interrupted where a signal says that what is being done is to end, which cleans up.
inline void checkInterruption() {
  if (programs::isStopped()) throw Interrupted();
}

}  // namespace pongsim::fuel
