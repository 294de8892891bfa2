#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace pongsim::cli {

inline constexpr int kDone = 0;
inline constexpr int kFailed = 1;
inline constexpr int kWrongUsage = 2;

/// The command line is wrong; ends the program with `kWrongUsage`.
class UsageError : public std::runtime_error {
 public:
  /// @param hint One line of help, or empty.
  explicit UsageError(const std::string& message, std::string hint = {});
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

/// @return Whether what is said on stderr is to have colours: it is a terminal that knows them, and the user does not
/// forbid them by the environment variable NO_COLOR.
bool errorsHaveColors();

/// Writes data to stdout, and at once. Says why where it can't, unless the reader has gone away.
/// @return Whether it could.
bool print(std::string_view data);

/// @return Whether the other end of stdout is closed, as that of `| head -1` is after a line.
bool outputIsClosed();

}  // namespace pongsim::cli
