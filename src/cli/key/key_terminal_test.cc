#include "cli/key/key_terminal.hh"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>

#include "support/pseudo_terminal.hh"

namespace pongsim::cli {
namespace {

TEST(KeyTerminal, IsAsBeforeAfterwards) {
  const auto terminal = test::PseudoTerminal::open();
  if (!terminal) GTEST_SKIP() << "no pseudo-terminals here";
  const termios before = terminal->settings();
  {
    const KeyTerminal keys(terminal->terminal());
    EXPECT_TRUE(keys.isTerminal());
    const termios meanwhile = terminal->settings();
    EXPECT_EQ(meanwhile.c_lflag & static_cast<tcflag_t>(ICANON | ECHO), 0U);
    EXPECT_NE(meanwhile.c_lflag & static_cast<tcflag_t>(ISIG), 0U);
  }
  const termios after = terminal->settings();
  EXPECT_EQ(std::memcmp(&before, &after, sizeof before), 0);
}

TEST(KeyTerminal, LeavesWhatIsNoTerminalAlone) {
  int pipe[2];
  ASSERT_EQ(::pipe(pipe), 0);
  EXPECT_FALSE(KeyTerminal(pipe[0]).isTerminal());
  close(pipe[0]);
  close(pipe[1]);
}

}  // namespace
}  // namespace pongsim::cli
