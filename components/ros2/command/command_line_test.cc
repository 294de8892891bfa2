#include <gtest/gtest.h>

#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "shared/program/command_line.hh"
#include "shared/program/console.hh"

namespace pongsim::ros2 {
namespace {

void addAction(CLI::App& program, cli::Work& work) {
  CLI::App* action = program.add_subcommand("topics", "List topics");
  action->add_flag("--json")->disable_flag_override();
  action->callback([&work] { work = [] { return 42; }; });
}

struct CommandOutcome {
  int code = 0;
  std::string said;
};

CommandOutcome outcomeOf(std::vector<std::string> words) {
  words.insert(words.begin(), "pongsim-ros2");
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  constexpr cli::AddCommand kActions[] = {addAction};
  testing::internal::CaptureStderr();
  const int code = cli::run(static_cast<int>(argv.size()), argv.data(), {.name = "pongsim ros2", .commands = kActions});
  return {code, testing::internal::GetCapturedStderr()};
}

TEST(Ros2CommandLine, DoesWhatTheActionDoes) { EXPECT_EQ(outcomeOf({"topics", "--json"}).code, 42); }

TEST(Ros2CommandLine, NamesTheNearestActionAndOption) {
  EXPECT_EQ(outcomeOf({"topcs"}).code, cli::kWrongUsage);
  EXPECT_EQ(outcomeOf({"topcs"}).said, "pongsim: error: unknown action 'topcs'\n  hint: did you mean 'topics'?\n");
  EXPECT_EQ(outcomeOf({"topics", "--jso"}).said,
            "pongsim: error: unknown option '--jso'\n  hint: did you mean '--json'?\n");
}

TEST(Ros2CommandLine, SaysWhatIsTooMuchOrMissing) {
  EXPECT_EQ(outcomeOf({}).code, cli::kWrongUsage);
  EXPECT_EQ(outcomeOf({"topics", "more"}).said, "pongsim: error: unexpected argument 'more'\n");
  EXPECT_EQ(outcomeOf({"topics", "--json=1"}).said, "pongsim: error: option '--json' takes no value\n");
}

}  // namespace
}  // namespace pongsim::ros2
