#pragma once

namespace pongsim::base {

/// Tells who runs, so that a crash can be put down to somebody. For the one thread that runs parts of others' making; a
/// crash of another thread is put down to nobody.
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

/// From now on a crash of the process (SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT) is said on stderr, in one line that
/// names the part that runs. Then it goes on as it would have.
void reportCrashes();

}  // namespace pongsim::base
