#include "fuel/interruption.hh"

#include <atomic>
#include <csignal>

#include "fuel/failure.hh"

namespace pongsim::fuel {

namespace {

// read by all threads that download
std::atomic<bool> interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal's handler may set it");

void interrupt(int) { interrupted = true; }

}  // namespace

void handleSignals() {
  struct sigaction action {};
  action.sa_handler = interrupt;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaction(signal, &action, nullptr);
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
}

bool isInterrupted() { return interrupted; }

void checkInterruption() {
  if (isInterrupted()) throw Interrupted();
}

}  // namespace pongsim::fuel
