#pragma once

#include <string_view>

namespace pongsim::cli {

// Exit codes, and output to the terminal.
inline constexpr int kDone = 0;
inline constexpr int kFailed = 1;
inline constexpr int kWrongUsage = 2;

/// Prints "pongsim: error: MESSAGE" on stderr, and the hint, if there is one, on a second line.
void sayError(std::string_view message, std::string_view hint = {});

/// Like `sayError`, for work that failed.
/// @return `kFailed`.
int fail(std::string_view message, std::string_view hint = {});

/// Prints "pongsim: MESSAGE" on stderr.
void say(std::string_view message);

/// Writes to stdout and flushes.
/// @return Whether it succeeded; false, without a message, if the reader has closed the pipe.
/// @throws Failure if it can't be written.
bool print(std::string_view text);

/// @return Whether the other end of stdout is closed, as by `| head -1` after one line.
bool outputIsClosed();

/// @return Whether to use colours in a file, such as STDERR_FILENO: it is a terminal that supports them, and the
/// environment variable NO_COLOR does not forbid them.
bool hasColors(int file);

}  // namespace pongsim::cli
