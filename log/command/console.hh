#pragma once

#include <string>
#include <string_view>

#include "log/store/failure.hh"

namespace pongsim::log {

// Exit codes, and how pongsim speaks to who sits at a terminal.
inline constexpr int kDone = 0;
inline constexpr int kFailed = 1;
inline constexpr int kWrongUsage = 2;

/// The command line is wrong; ends the program with `kWrongUsage`.
class UsageError : public Failure {
 public:
  using Failure::Failure;
};

/// Says on stderr "pongsim: error: MESSAGE", and the hint, if there is one, on a second line.
void sayError(std::string_view message, std::string_view hint = {});

/// Says "pongsim: MESSAGE" on stderr.
void say(std::string_view message);

/// Writes to stdout, and at once. A reader that has gone away is no failure.
/// @throws Failure where it can't.
void print(std::string_view text);

}  // namespace pongsim::log
