#pragma once

#include <sys/types.h>

#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace pongsim::test {

/// After this time something counts as failed, even on a machine that is busy with other tests.
inline constexpr std::chrono::seconds kDeadline{60};

/// A program that a test started. Its output is read in the background. The destructor kills it.
class Process {
 public:
  struct Options {
    /// Added to this process's own environment.
    std::map<std::string, std::string> environment;
    /// Working folder; empty: this process's own.
    std::filesystem::path folder;
  };

  /// Starts `arguments[0]`, which is looked up in PATH if it has no slash. Its standard input is empty.
  /// @throws std::runtime_error if no process can be started. If the program is missing, the process exits with 127.
  explicit Process(const std::vector<std::string>& arguments, const Options& options = Options());
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  pid_t pid() const { return pid_; }

  /// Sends it a signal, if it has not ended.
  void kill(int signal) const;

  /// Waits until it has ended and all that it wrote has been read.
  /// @return Its exit code, or 128 plus the number of the signal that ended it; nothing after `timeout`.
  std::optional<int> wait(std::chrono::nanoseconds timeout = kDeadline);

  /// Waits until its standard output or its standard error holds something that `pattern` (a regular expression,
  /// ECMAScript) matches. Returns early if it ends without.
  bool waitForOutput(const std::string& pattern, std::chrono::nanoseconds timeout = kDeadline);
  bool waitForError(const std::string& pattern, std::chrono::nanoseconds timeout = kDeadline);

  /// What it has written so far.
  std::string output() const;
  std::string error() const;

 private:
  struct Stream {
    int descriptor = -1;
    std::string text;
  };

  void read();
  /// @return Whether more output can follow.
  bool takeFrom(Stream& stream);
  bool waitFor(const Stream& stream, const std::string& pattern, std::chrono::nanoseconds timeout);

  pid_t pid_ = -1;
  int stop_[2] = {-1, -1};
  std::optional<int> exitCode_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  Stream output_;
  Stream error_;
  bool readAll_ = false;
  std::thread reader_;
};

}  // namespace pongsim::test
