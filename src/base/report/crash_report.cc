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

/// The part that runs on a thread.
struct RunningThread {
  /// The kernel's thread id; 0: this element of the table is free.
  std::atomic<long> thread = 0;
  std::atomic<const char*> name = nullptr;
  std::atomic<const char*> doing = nullptr;
};

// Global, because a signal handler has access to nothing else, and a process has one set of handlers. A crash on a
// thread beyond this number names no part.
constexpr std::size_t kMostThreads = 256;
std::array<RunningThread, kMostThreads> running;

/// This thread's element of the table while this object lives; a spare one if the table is full.
class TableSlot {
 public:
  TableSlot() {
    const long thread = syscall(SYS_gettid);
    for (RunningThread& each : running) {
      long none = 0;
      if (!each.thread.compare_exchange_strong(none, thread)) continue;
      slot_ = &each;
      return;
    }
  }
  ~TableSlot() {
    if (slot_ == &spare_) return;
    slot_->name = nullptr;
    slot_->thread = 0;
  }
  TableSlot(const TableSlot&) = delete;
  TableSlot& operator=(const TableSlot&) = delete;

  RunningThread& operator*() const { return *slot_; }

 private:
  RunningThread spare_;
  RunningThread* slot_ = &spare_;
};

RunningThread& runningHere() {
  thread_local const TableSlot slot;
  return *slot;
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
class SignalSafeLine {
 public:
  SignalSafeLine& operator<<(const char* text) {
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
    SignalSafeLine line;
    line << "pongsim: error: crashed with " << crash.text;
    const long thread = syscall(SYS_gettid);
    for (const RunningThread& each : running) {
      const char* const name = each.name;
      if (name != nullptr && each.thread == thread) line << " in " << name << ", " << each.doing;
    }
    line << "\n";
    line.write();
    sigaction(signal, &crash.before, nullptr);
  }
  // the signal is blocked until this handler returns, and then goes to the handler before this one
  raise(signal);
}

}  // namespace

RunningPart::RunningPart(const char* name, const char* doing) {
  RunningThread& here = runningHere();
  name_ = here.name.load(std::memory_order_relaxed);
  doing_ = here.doing.load(std::memory_order_relaxed);
  here.doing.store(doing, std::memory_order_relaxed);
  here.name.store(name, std::memory_order_relaxed);
}

RunningPart::~RunningPart() {
  RunningThread& here = runningHere();
  here.doing.store(doing_, std::memory_order_relaxed);
  here.name.store(name_, std::memory_order_relaxed);
}

CrashStack::CrashStack() {
  stack_t there{};
  // a stack is already set, such as a sanitizer's
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
  // for the main thread, never destroyed; in static memory, so that leak sanitizers do not report it
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
