#pragma once

#include <string_view>

namespace pongsim::programs {

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
/// @return `kDone`, or `kFailed`, without a message, if the reader has closed the pipe.
/// @throws Failure if it can't be written.
int print(std::string_view text);

/// @return Whether stdout is a terminal with colours, and NO_COLOR is not set.
bool outputHasColors();

}  // namespace pongsim::programs
