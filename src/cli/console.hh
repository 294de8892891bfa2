#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace pongsim::cli {

inline constexpr int kDone = 0;
inline constexpr int kFailed = 1;
inline constexpr int kWrongUsage = 2;

/// The command line is wrong; the program exits with `kWrongUsage`.
class UsageError : public std::runtime_error {
 public:
  /// @param hint One line of help, or empty.
  explicit UsageError(const std::string& message, std::string hint = {});
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

/// @return Whether to use colours on stderr: it is a terminal that supports them, and the environment variable NO_COLOR
/// does not forbid them.
bool errorsHaveColors();

/// Writes data to stdout and flushes it. Reports a failure, unless the reader has closed the pipe.
/// @return Whether it succeeded.
bool print(std::string_view data);

/// @return Whether the other end of stdout is closed, as by `| head -1` after one line.
bool outputIsClosed();

}  // namespace pongsim::cli
