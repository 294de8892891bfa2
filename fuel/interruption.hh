#pragma once

namespace pongsim::fuel {

/// From now on SIGINT, SIGTERM and SIGHUP let what is being done end with `Interrupted`, which cleans up; a second one
/// ends the process. SIGXFSZ, of a limit on the size of files, becomes an error of the write.
void handleSignals();

/// @return Whether such a signal has come.
bool isInterrupted();

/// @throws Interrupted
void checkInterruption();

}  // namespace pongsim::fuel
