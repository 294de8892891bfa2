#include "shared/program/stop_signal.hh"

#include <atomic>
#include <csignal>

namespace pongsim::cli {

namespace {

std::atomic<bool> stopped = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal's handler may set it");

void stop(int) { stopped = true; }

}  // namespace

void takeStopSignals() {
  struct sigaction action {};
  action.sa_handler = stop;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaction(signal, &action, nullptr);
}

bool isStopped() { return stopped; }

}  // namespace pongsim::cli
