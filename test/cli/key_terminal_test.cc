#include "cli/key_terminal.hh"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include <cstring>

namespace pongsim::cli {
namespace {

TEST(KeyTerminal, IsAsBeforeAfterwards) {
  const int control = posix_openpt(O_RDWR | O_NOCTTY);
  ASSERT_GE(control, 0);
  ASSERT_EQ(grantpt(control), 0);
  ASSERT_EQ(unlockpt(control), 0);
  const int terminal = open(ptsname(control), O_RDWR | O_NOCTTY);
  ASSERT_GE(terminal, 0);
  termios before{}, meanwhile{}, after{};
  ASSERT_EQ(tcgetattr(terminal, &before), 0);
  {
    const KeyTerminal keys(terminal);
    EXPECT_TRUE(keys.isTerminal());
    tcgetattr(terminal, &meanwhile);
    EXPECT_EQ(meanwhile.c_lflag & static_cast<tcflag_t>(ICANON | ECHO), 0U);
    EXPECT_NE(meanwhile.c_lflag & static_cast<tcflag_t>(ISIG), 0U);
  }
  tcgetattr(terminal, &after);
  EXPECT_EQ(std::memcmp(&before, &after, sizeof before), 0);
  close(terminal);
  close(control);
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
