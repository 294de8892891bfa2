#include "cli/view/sixel_terminal.hh"

#include <gtest/gtest.h>
#include <unistd.h>

#include <thread>

#include "support/pseudo_terminal.hh"

namespace pongsim::cli {
namespace {

constexpr std::chrono::milliseconds kLongEnough{60'000};

TEST(SixelTerminal, IsOneThatSaysSo) {
  struct Terminal {
    const char* answer;
    bool knows;
  };
  for (const auto& [answer, knows] :
       {Terminal{"\033[?62;4;22c", true}, Terminal{"\033[?4c", true}, Terminal{"x\033[?63;1;4c", true},
        Terminal{"\033[?64;14;22c", false}, Terminal{"\033[?6c", false}}) {
    const auto terminal = test::PseudoTerminal::open();
    if (!terminal) GTEST_SKIP() << "no pseudo-terminals here";
    std::thread user([&terminal, answer] {
      terminal->waitFor("\033[c");
      terminal->type(answer);
    });
    EXPECT_EQ(knowsSixels(terminal->terminal(), terminal->terminal(), kLongEnough), knows) << answer;
    user.join();
  }
}

TEST(SixelTerminal, IsNotOneThatSaysNothing) {
  const auto terminal = test::PseudoTerminal::open();
  if (!terminal) GTEST_SKIP() << "no pseudo-terminals here";
  EXPECT_FALSE(knowsSixels(terminal->terminal(), terminal->terminal(), std::chrono::milliseconds(10)));
}

TEST(SixelTerminal, IsAskedOnlyWhereThereIsOne) {
  int pipe[2];
  ASSERT_EQ(::pipe(pipe), 0);
  EXPECT_FALSE(knowsSixels(pipe[0], pipe[1], kLongEnough));
  const auto terminal = test::PseudoTerminal::open();
  EXPECT_FALSE(terminal && knowsSixels(terminal->terminal(), pipe[1], kLongEnough));
  close(pipe[0]);
  close(pipe[1]);
}

}  // namespace
}  // namespace pongsim::cli
