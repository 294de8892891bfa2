#pragma once

#include <string_view>

namespace pongsim::programs {

// Exit codes, and how pongsim speaks to who sits at a terminal.
inline constexpr int kDone = 0;
inline constexpr int kFailed = 1;
inline constexpr int kWrongUsage = 2;

/// Says on stderr "pongsim: error: MESSAGE", and the hint, if there is one, on a second line.
void sayError(std::string_view message, std::string_view hint = {});

/// As `sayError`, for work that could not be done.
/// @return `kFailed`.
int fail(std::string_view message, std::string_view hint = {});

/// Says "pongsim: MESSAGE" on stderr.
void say(std::string_view message);

/// Writes to stdout, and at once.
/// @return `kDone`, or `kFailed` where the reader has gone away, of which nothing is said.
/// @throws Failure where it can't.
int print(std::string_view text);

/// @return Whether stdout is a terminal that knows colours, and the user does not forbid them by NO_COLOR.
bool outputHasColors();

}  // namespace pongsim::programs
