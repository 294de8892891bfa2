#pragma once

#include <cstddef>
#include <memory>

namespace pongsim::base {

/// Tells who runs on this thread, so that a crash can be put down to somebody. A crash of a thread without one is put
/// down to nobody.
class RunningPart {
 public:
  /// @param name Who runs: "the system my-system of robot". Must outlive this.
  /// @param doing What: "in preUpdate".
  RunningPart(const char* name, const char* doing);
  /// Whoever ran before does so again.
  ~RunningPart();
  RunningPart(const RunningPart&) = delete;
  RunningPart& operator=(const RunningPart&) = delete;

 private:
  const char* name_;
  const char* doing_;
};

/// A place for this thread to report a crash from, for an overflow of the stack leaves none on it. To end on the thread
/// on which it was made.
class CrashStack {
 public:
  CrashStack();
  ~CrashStack();
  CrashStack(const CrashStack&) = delete;
  CrashStack& operator=(const CrashStack&) = delete;

 private:
  std::unique_ptr<std::byte[]> memory_;
};

/// From now on a crash of the process (SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT) is said on stderr, in one line that
/// names the part that runs. Then it goes on as it would have. Threads beside the main
/// one need a `CrashStack` for overflows of their stacks.
void reportCrashes();

}  // namespace pongsim::base
