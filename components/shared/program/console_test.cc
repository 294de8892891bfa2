#include "shared/program/console.hh"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "shared/program/failure.hh"
#include "support/pseudo_terminal.hh"

namespace pongsim::cli {
namespace {

/// Redirects stdout to a file while it exists.
class StdoutAt {
 public:
  explicit StdoutAt(int file) : kept_(dup(STDOUT_FILENO)) {
    std::fflush(stdout);
    dup2(file, STDOUT_FILENO);
  }
  ~StdoutAt() {
    // otherwise the failed output stays in the buffer and is written later
    std::setvbuf(stdout, nullptr, _IONBF, 0);
    dup2(kept_, STDOUT_FILENO);
    close(kept_);
  }
  StdoutAt(const StdoutAt&) = delete;
  StdoutAt& operator=(const StdoutAt&) = delete;

 private:
  int kept_;
};

TEST(ProgramsConsole, SaysErrorsWithHints) {
  testing::internal::CaptureStderr();
  EXPECT_EQ(fail("no world runs", "start one"), kFailed);
  sayError("it is late");
  say("warning: it rains");
  EXPECT_EQ(
      testing::internal::GetCapturedStderr(),
      "pongsim: error: no world runs\n  hint: start one\npongsim: error: it is late\npongsim: warning: it rains\n");
}

TEST(ProgramsConsole, PrintsAtOnce) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  {
    const StdoutAt at(ends[1]);
    EXPECT_TRUE(print("a line\n"));
    char text[8] = {};
    EXPECT_EQ(read(ends[0], text, sizeof(text)), 7);
    EXPECT_STREQ(text, "a line\n");
  }
  close(ends[0]);
  close(ends[1]);
}

TEST(ProgramsConsole, SaysNothingOfAReaderThatHasGone) {
  std::signal(SIGPIPE, SIG_IGN);
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  close(ends[0]);
  const StdoutAt at(ends[1]);
  testing::internal::CaptureStderr();
  EXPECT_FALSE(print("a line\n"));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  close(ends[1]);
}

TEST(ProgramsConsole, SaysWhyItCantPrint) {
  const int full = open("/dev/full", O_WRONLY | O_CLOEXEC);
  ASSERT_GE(full, 0);
  std::string why;
  {
    const StdoutAt at(full);
    try {
      print("a line\n");
    } catch (const Failure& failure) {
      why = failure.what();
    }
  }
  close(full);
  EXPECT_EQ(why, "can't write to stdout: No space left on device");
}

TEST(ProgramsConsole, HasColoursOnATerminalThatKnowsThemUnlessForbidden) {
  const auto terminal = test::PseudoTerminal::open();
  if (terminal == nullptr) GTEST_SKIP() << "there are no terminals on this machine";
  unsetenv("NO_COLOR");
  setenv("TERM", "xterm", 1);
  EXPECT_TRUE(hasColors(terminal->terminal()));
  setenv("TERM", "dumb", 1);
  EXPECT_FALSE(hasColors(terminal->terminal()));
  unsetenv("TERM");
  EXPECT_FALSE(hasColors(terminal->terminal()));
  setenv("TERM", "xterm", 1);
  setenv("NO_COLOR", "1", 1);
  EXPECT_FALSE(hasColors(terminal->terminal()));
  setenv("NO_COLOR", "", 1);
  EXPECT_TRUE(hasColors(terminal->terminal()));
}

TEST(ProgramsConsole, HasNoColoursInAPipe) {
  setenv("TERM", "xterm", 1);
  unsetenv("NO_COLOR");
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  EXPECT_FALSE(hasColors(ends[1]));
  close(ends[0]);
  close(ends[1]);
}

TEST(ProgramsConsole, SeesThatTheReaderHasGone) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const StdoutAt at(ends[1]);
  EXPECT_FALSE(outputIsClosed());
  close(ends[0]);
  EXPECT_TRUE(outputIsClosed());
  close(ends[1]);
}

}  // namespace
}  // namespace pongsim::cli
