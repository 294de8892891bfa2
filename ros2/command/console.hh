#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace pongsim::ros2 {

// Exit codes, and how pongsim speaks to who sits at a terminal.
inline constexpr int kDone = 0;
inline constexpr int kFailed = 1;
inline constexpr int kWrongUsage = 2;

/// The command line is wrong; ends the program with `kWrongUsage`.
class UsageError : public std::runtime_error {
 public:
  /// @param hint One line of help, or empty.
  explicit UsageError(const std::string& message, std::string hint = {})
      : std::runtime_error(message), hint_(std::move(hint)) {}
  const std::string& hint() const { return hint_; }

 private:
  std::string hint_;
};

/// Says on stderr "pongsim: error: MESSAGE", and the hint, if there is one, on a second line.
void sayError(std::string_view message, std::string_view hint = {});

/// As `sayError`, for work that could not be done.
/// @return `kFailed`.
int fail(std::string_view message, std::string_view hint = {});

/// Says "pongsim: MESSAGE" on stderr.
void say(std::string_view message);

/// Writes to stdout, and at once. Says why where it can't, unless the reader has gone away.
/// @return `kDone` or `kFailed`.
int print(std::string_view data);

}  // namespace pongsim::ros2
