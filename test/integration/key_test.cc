#include <gtest/gtest.h>
#include <signal.h>

#include <cstring>
#include <string>

#include "integration/program.hh"
#include "support/pseudo_terminal.hh"
#include "support/test_domain.hh"

namespace pongsim::test {
namespace {

class Keyboard : public testing::Test {
 protected:
  void SetUp() override {
    if (!terminal_) GTEST_SKIP() << "no pseudo-terminals here";
  }

  /// Starts `pongsim key` with this standard input.
  static std::unique_ptr<Process> start(const std::string& before, const std::string& input) {
    testDomain();
    auto process = std::make_unique<Process>(
        std::vector<std::string>{"sh", "-c", before + " '" PONGSIM_PROGRAM "' key --timeout 60000 " + input});
    return process;
  }

  void expectAsBefore(const termios& before) const {
    const termios after = terminal_->settings();
    EXPECT_EQ(after.c_lflag, before.c_lflag);
    EXPECT_EQ(after.c_iflag, before.c_iflag);
    EXPECT_EQ(std::memcmp(after.c_cc, before.c_cc, sizeof after.c_cc), 0);
  }

  const std::unique_ptr<PseudoTerminal> terminal_ = PseudoTerminal::open();
  const std::unique_ptr<Process> heard_ =
      pongsim::test::start({"topic", "-et", "/keyboard/keypress", "-m", "Int32", "--json-output"});
};

TEST_F(Keyboard, TakesKeysFromAPipeInOrder) {
  const auto keys = start("printf 'w\\033[D 7' |", "");
  EXPECT_EQ(keys->wait(), 0) << keys->error();
  EXPECT_EQ(keys->error(), "pongsim: W (87)\npongsim: left (16777234)\npongsim: space (32)\npongsim: 7 (55)\n");
  EXPECT_EQ(keys->output(), "");
  ASSERT_TRUE(heard_->waitForOutput("55"));
  EXPECT_EQ(heard_->output(), "{\"data\":87}\n{\"data\":16777234}\n{\"data\":32}\n{\"data\":55}\n");
}

TEST_F(Keyboard, TellsOfThemAsJson) {
  const auto keys = start("printf 'w\\033[D' |", "--json");
  EXPECT_EQ(keys->wait(), 0) << keys->error();
  EXPECT_EQ(keys->output(), "{\"key\":\"W\",\"code\":87}\n{\"key\":\"left\",\"code\":16777234}\n");
  EXPECT_EQ(keys->error(), "");
}

TEST_F(Keyboard, SendsTheKeysOfATerminalAndLeavesItAsItWas) {
  const termios before = terminal_->settings();
  const auto keys = start("exec", "< " + terminal_->name());
  ASSERT_TRUE(keys->waitForError("keys go to /keyboard/keypress")) << keys->error();
  EXPECT_EQ(terminal_->settings().c_lflag & static_cast<tcflag_t>(ICANON | ECHO), 0U);
  terminal_->type("\x1b[A");
  EXPECT_TRUE(keys->waitForError("up \\(16777235\\)")) << keys->error();
  EXPECT_TRUE(heard_->waitForOutput("16777235"));
  terminal_->type("\x1b");
  EXPECT_TRUE(keys->waitForError("escape \\(16777216\\)")) << keys->error();
  terminal_->type("q");
  EXPECT_EQ(keys->wait(), 0) << keys->error();
  expectAsBefore(before);
}

TEST_F(Keyboard, LeavesTheTerminalAsItWasAtASignal) {
  const termios before = terminal_->settings();
  for (const int signal : {SIGTERM, SIGINT}) {
    const auto keys = start("exec", "< " + terminal_->name());
    ASSERT_TRUE(keys->waitForError("keys go to")) << keys->error();
    keys->kill(signal);
    EXPECT_EQ(keys->wait(), 0) << keys->error();
    expectAsBefore(before);
  }
}

TEST_F(Keyboard, EndsAtCtrlC) {
  const termios before = terminal_->settings();
  const auto keys = start("setsid --ctty --wait", "< " + terminal_->name());
  ASSERT_TRUE(keys->waitForError("keys go to")) << keys->error();
  terminal_->type("\x03");
  EXPECT_EQ(keys->wait(), 0) << keys->error();
  expectAsBefore(before);
}

TEST(KeyboardAlone, FailsAScriptWhereNobodyListens) {
  const Outcome keys = runToEnd({"key", "--timeout", "100"});
  EXPECT_EQ(keys.exitCode, 1);
  EXPECT_EQ(keys.error, "pongsim: error: no subscriber on /keyboard/keypress\n");
}

}  // namespace
}  // namespace pongsim::test
