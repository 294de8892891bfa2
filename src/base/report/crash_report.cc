#include "base/report/crash_report.hh"

#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstddef>
#include <cstring>
#include <memory>
#include <new>

namespace pongsim::base {

namespace {

/// What runs on a thread.
struct Running {
  /// 0: the entry is free.
  std::atomic<long> thread = 0;
  std::atomic<const char*> name = nullptr;
  std::atomic<const char*> doing = nullptr;
};

// Global, because a signal handler has access to nothing else, and a process has one set of handlers. If more threads
// than this are running, a crash on one of the others names no part.
constexpr std::size_t kMostThreads = 256;
std::array<Running, kMostThreads> running;

/// A thread's entry in the table, for the lifetime of this object.
class Place {
 public:
  Place() {
    const long thread = syscall(SYS_gettid);
    for (Running& each : running) {
      long none = 0;
      if (!each.thread.compare_exchange_strong(none, thread)) continue;
      place_ = &each;
      return;
    }
  }
  ~Place() {
    if (place_ == &spare_) return;
    place_->name = nullptr;
    place_->thread = 0;
  }
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;

  Running& operator*() const { return *place_; }

 private:
  Running spare_;
  Running* place_ = &spare_;
};

Running& runningHere() {
  thread_local const Place place;
  return *place;
}

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

/// A line of output, assembled and written using only calls allowed in signal handlers.
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
    const long thread = syscall(SYS_gettid);
    for (const Running& each : running) {
      const char* const name = each.name;
      if (name != nullptr && each.thread == thread) line << " in " << name << ", " << each.doing;
    }
    line << "\n";
    line.write();
    sigaction(signal, &crash.before, nullptr);
  }
  // delivered after this function returns, to whatever handled it before
  raise(signal);
}

}  // namespace

RunningPart::RunningPart(const char* name, const char* doing) {
  Running& here = runningHere();
  name_ = here.name.load(std::memory_order_relaxed);
  doing_ = here.doing.load(std::memory_order_relaxed);
  here.doing.store(doing, std::memory_order_relaxed);
  here.name.store(name, std::memory_order_relaxed);
}

RunningPart::~RunningPart() {
  Running& here = runningHere();
  here.doing.store(doing_, std::memory_order_relaxed);
  here.name.store(name_, std::memory_order_relaxed);
}

CrashStack::CrashStack() {
  stack_t there{};
  // a sanitizer has its own
  if (sigaltstack(nullptr, &there) != 0 || (there.ss_flags & SS_DISABLE) == 0) return;
  constexpr std::size_t kSize = 64 * 1024;
  memory_ = std::make_unique<std::byte[]>(kSize);
  stack_t stack{};
  stack.ss_sp = memory_.get();
  stack.ss_size = kSize;
  sigaltstack(&stack, nullptr);
}

CrashStack::~CrashStack() {
  if (!memory_) return;
  stack_t none{};
  none.ss_flags = SS_DISABLE;
  sigaltstack(&none, nullptr);
}

void reportCrashes() {
  // for the main thread, until the process ends: in static memory, which a sanitizer takes for no leak
  alignas(CrashStack) static std::byte place[sizeof(CrashStack)];
  static const CrashStack* const stack = new (place) CrashStack;
  static_cast<void>(stack);
  for (Crash& crash : crashes) {
    struct sigaction action {};
    action.sa_handler = report;
    action.sa_flags = SA_ONSTACK;
    sigaction(crash.signal, &action, &crash.before);
  }
}

}  // namespace pongsim::base
