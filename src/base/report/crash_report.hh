#pragma once

#include <cstddef>
#include <memory>

namespace pongsim::base {

/// Records what runs on this thread, so that a crash report can name it. Without one, the report names no part.
class RunningPart {
 public:
  /// @param name The part: "the system my-system of robot". Must outlive this.
  /// @param doing What it does: "in preUpdate".
  RunningPart(const char* name, const char* doing);
  /// Restores the part that ran before.
  ~RunningPart();
  RunningPart(const RunningPart&) = delete;
  RunningPart& operator=(const RunningPart&) = delete;

 private:
  const char* name_;
  const char* doing_;
};

/// An alternate signal stack, from which this thread can report a crash after a stack overflow. Must be destroyed on
/// the thread that created it.
class CrashStack {
 public:
  CrashStack();
  ~CrashStack();
  CrashStack(const CrashStack&) = delete;
  CrashStack& operator=(const CrashStack&) = delete;

 private:
  std::unique_ptr<std::byte[]> memory_;
};

/// Makes crashes of the process (SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT) print one line on stderr with the part that
/// was running; then the crash proceeds as usual. Threads other than the main one need a `CrashStack` to report stack
/// overflows.
void reportCrashes();

}  // namespace pongsim::base
