#include "base/crash_report.hh"

#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstddef>
#include <cstring>

namespace pongsim::base {

namespace {

// A handler of signals gets at nothing but this: a process has one set of them.
std::atomic<const char*> runningName = nullptr;
std::atomic<const char*> runningDoing = nullptr;
std::atomic<long> runningThread = 0;

struct Crash {
  int signal;
  const char* text;
  struct sigaction before;
};
std::array<Crash, 5> crashes = {{{SIGSEGV, "SIGSEGV", {}},
                                 {SIGBUS, "SIGBUS", {}},
                                 {SIGFPE, "SIGFPE", {}},
                                 {SIGILL, "SIGILL", {}},
                                 {SIGABRT, "SIGABRT", {}}}};

// an overflow of the stack leaves no place on it
alignas(16) std::array<char, 64 * 1024> handlerStack;

/// One line, put together and written without anything that a handler of signals may not call.
class Line {
 public:
  Line& operator<<(const char* text) {
    const std::size_t length = std::min(std::strlen(text), text_.size() - size_);
    std::memcpy(text_.data() + size_, text, length);
    size_ += length;
    return *this;
  }
  void write() const {
    if (::write(STDERR_FILENO, text_.data(), size_) < 0) return;
  }

 private:
  std::array<char, 512> text_{};
  std::size_t size_ = 0;
};

void report(int signal) {
  for (Crash& crash : crashes) {
    if (crash.signal != signal) continue;
    Line line;
    line << "pongsim: error: crashed with " << crash.text;
    const char* const name = runningName;
    if (name != nullptr && runningThread == syscall(SYS_gettid)) line << " in " << name << ", " << runningDoing;
    line << "\n";
    line.write();
    sigaction(signal, &crash.before, nullptr);
  }
  // comes when this function has returned, to whoever saw to it before
  raise(signal);
}

}  // namespace

RunningPart::RunningPart(const char* name, const char* doing) : name_(runningName), doing_(runningDoing) {
  // the thread's number costs a call of the kernel, and does not change
  thread_local const long thread = syscall(SYS_gettid);
  runningThread.store(thread, std::memory_order_relaxed);
  runningDoing.store(doing, std::memory_order_relaxed);
  runningName.store(name, std::memory_order_relaxed);
}

RunningPart::~RunningPart() {
  runningDoing.store(doing_, std::memory_order_relaxed);
  runningName.store(name_, std::memory_order_relaxed);
}

void reportCrashes() {
  stack_t there{};
  // a sanitizer has one of its own
  if (sigaltstack(nullptr, &there) == 0 && (there.ss_flags & SS_DISABLE) != 0) {
    stack_t stack{};
    stack.ss_sp = handlerStack.data();
    stack.ss_size = handlerStack.size();
    sigaltstack(&stack, nullptr);
  }
  for (Crash& crash : crashes) {
    struct sigaction action {};
    action.sa_handler = report;
    action.sa_flags = SA_ONSTACK;
    sigaction(crash.signal, &action, &crash.before);
  }
}

}  // namespace pongsim::base
