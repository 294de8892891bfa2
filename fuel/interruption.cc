#include "fuel/interruption.hh"

#include <csignal>

#include "fuel/failure.hh"

namespace pongsim::fuel {

namespace {

volatile std::sig_atomic_t interrupted = 0;

void interrupt(int) { interrupted = 1; }

}  // namespace

void handleSignals() {
  struct sigaction action {};
  action.sa_handler = interrupt;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaction(signal, &action, nullptr);
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
}

bool isInterrupted() { return interrupted != 0; }

void checkInterruption() {
  if (isInterrupted()) throw Interrupted();
}

}  // namespace pongsim::fuel
