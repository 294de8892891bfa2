#include "cli/console.hh"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>

#include "support/pseudo_terminal.hh"

namespace pongsim::cli {
namespace {

/// @return `errorsHaveColors()` where stderr is that file.
bool haveColorsOn(int file) {
  const int kept = dup(STDERR_FILENO);
  dup2(file, STDERR_FILENO);
  const bool result = errorsHaveColors();
  dup2(kept, STDERR_FILENO);
  close(kept);
  return result;
}

TEST(Console, HasColoursOnATerminalThatKnowsThemUnlessForbidden) {
  const auto terminal = test::PseudoTerminal::open();
  if (terminal == nullptr) GTEST_SKIP() << "there are no terminals on this machine";
  unsetenv("NO_COLOR");
  setenv("TERM", "xterm", 1);
  EXPECT_TRUE(haveColorsOn(terminal->terminal()));
  setenv("TERM", "dumb", 1);
  EXPECT_FALSE(haveColorsOn(terminal->terminal()));
  unsetenv("TERM");
  EXPECT_FALSE(haveColorsOn(terminal->terminal()));
  setenv("TERM", "xterm", 1);
  setenv("NO_COLOR", "1", 1);
  EXPECT_FALSE(haveColorsOn(terminal->terminal()));
  setenv("NO_COLOR", "", 1);
  EXPECT_TRUE(haveColorsOn(terminal->terminal()));
}

TEST(Console, HasNoColoursInAPipe) {
  unsetenv("NO_COLOR");
  setenv("TERM", "xterm", 1);
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  EXPECT_FALSE(haveColorsOn(ends[1]));
  close(ends[0]);
  close(ends[1]);
}

}  // namespace
}  // namespace pongsim::cli
