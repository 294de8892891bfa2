#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace pongsim::ros2 {

// Exit codes, and output for users at a terminal.
inline constexpr int kDone = 0;
inline constexpr int kFailed = 1;
inline constexpr int kWrongUsage = 2;

/// The command line is wrong; the program exits with `kWrongUsage`.
class UsageError : public std::runtime_error {
 public:
  /// @param hint One line of help, or empty.
  explicit UsageError(const std::string& message, std::string hint = {})
      : std::runtime_error(message), hint_(std::move(hint)) {}
  const std::string& hint() const { return hint_; }

 private:
  std::string hint_;
};

/// Prints "pongsim: error: MESSAGE" on stderr, and the hint, if any, on a second line.
void sayError(std::string_view message, std::string_view hint = {});

/// Like `sayError`, for work that failed.
/// @return `kFailed`.
int fail(std::string_view message, std::string_view hint = {});

/// Prints "pongsim: MESSAGE" on stderr.
void say(std::string_view message);

/// Writes to stdout and flushes it. Reports a failure, unless the reader has closed the pipe.
/// @return `kDone` or `kFailed`.
int print(std::string_view data);

}  // namespace pongsim::ros2
