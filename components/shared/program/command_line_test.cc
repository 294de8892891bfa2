#include "shared/program/command_line.hh"

#include <gtest/gtest.h>

#include <CLI/App.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "shared/program/console.hh"
#include "shared/program/failure.hh"

namespace pongsim::cli {
namespace {

void addTopics(CLI::App& program, Work& work) {
  CLI::App* action = program.add_subcommand("topics", "List topics");
  action->add_flag("--json")->disable_flag_override();
  action->add_option("--world")->type_name("WORLD");
  action->callback([&work] { work = [] { return 42; }; });
}

/// An action with an argument.
void addPlay(CLI::App& program, Work& work) {
  const auto file = std::make_shared<std::string>();
  CLI::App* action = program.add_subcommand("play", "Play a file");
  action->add_option("FILE", *file);
  action->callback([&work, file] {
    if (file->empty()) throw UsageError("no file given", "pongsim test play FILE");
    work = [file]() -> int {
      if (*file == "topics") return 7;
      if (*file == "odd") throw std::runtime_error("it is odd");
      throw Failure("'" + *file + "' is not there", "look for it");
    };
  });
}

/// A hidden action.
void addHidden(CLI::App& program, Work& work) {
  CLI::App* action = program.add_subcommand("fetch", "Do what another program asks for")->group("");
  action->callback([&work] { work = [] { return 8; }; });
}

constexpr AddCommand kActions[] = {addTopics, addPlay, addHidden};

struct Outcome {
  int code = 0;
  std::string printed;
  std::string said;
};

Outcome outcomeOf(std::vector<std::string> words,
                  const Program& program = {
                      .name = "pongsim test", .about = "Tests.", .commands = kActions, .footer = "The end."}) {
  words.insert(words.begin(), "pongsim-test");
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const int code = run(static_cast<int>(argv.size()), argv.data(), program);
  return {code, testing::internal::GetCapturedStdout(), testing::internal::GetCapturedStderr()};
}

/// @return The error message for a wrong command line.
std::string wrong(std::vector<std::string> words) {
  const Outcome outcome = outcomeOf(std::move(words));
  EXPECT_EQ(outcome.code, kWrongUsage);
  EXPECT_EQ(outcome.printed, "");
  return outcome.said;
}

TEST(ProgramsCommandLine, DoesWhatTheActionDoes) {
  EXPECT_EQ(outcomeOf({"topics", "--json"}).code, 42);
  EXPECT_EQ(outcomeOf({"fetch"}).code, 8);
}

TEST(ProgramsCommandLine, LeavesTheWordsBehindAnActionToIt) { EXPECT_EQ(outcomeOf({"play", "topics"}).code, 7); }

TEST(ProgramsCommandLine, NamesTheNearestActionAndOption) {
  EXPECT_EQ(wrong({"topcs"}), "pongsim: error: unknown action 'topcs'\n  hint: did you mean 'topics'?\n");
  EXPECT_EQ(wrong({"topcs", "--help"}), "pongsim: error: unknown action 'topcs'\n  hint: did you mean 'topics'?\n");
  EXPECT_EQ(wrong({"quux"}), "pongsim: error: unknown action 'quux'\n  hint: pongsim test --help lists them\n");
  EXPECT_EQ(wrong({"topics", "--jso"}), "pongsim: error: unknown option '--jso'\n  hint: did you mean '--json'?\n");
  EXPECT_EQ(wrong({"topics", "--quux=1"}),
            "pongsim: error: unknown option '--quux'\n  hint: pongsim test topics --help lists the options\n");
}

TEST(ProgramsCommandLine, NamesNoActionThatNobodyIsToldOf) {
  EXPECT_EQ(wrong({"fetc"}), "pongsim: error: unknown action 'fetc'\n  hint: pongsim test --help lists them\n");
  EXPECT_EQ(outcomeOf({"--help"}).printed.find("fetch"), std::string::npos);
}

TEST(ProgramsCommandLine, SaysWhatIsTooMuchOrMissing) {
  EXPECT_EQ(wrong({}), "pongsim: error: no action given\n  hint: pongsim test --help lists them\n");
  EXPECT_EQ(wrong({"play"}), "pongsim: error: no file given\n  hint: pongsim test play FILE\n");
  EXPECT_EQ(wrong({"topics", "more"}), "pongsim: error: unexpected argument 'more'\n");
  EXPECT_EQ(wrong({"topics", "--json=1"}), "pongsim: error: option '--json' takes no value\n");
  EXPECT_EQ(wrong({"topics", "--world"}), "pongsim: error: option '--world' needs a value\n");
  EXPECT_EQ(wrong({"topics", "--world", "a", "--world", "b"}), "pongsim: error: option '--world' is given twice\n");
}

TEST(ProgramsCommandLine, SaysWhyTheWorkFailed) {
  const Outcome failed = outcomeOf({"play", "a.mcap"});
  EXPECT_EQ(failed.code, kFailed);
  EXPECT_EQ(failed.said, "pongsim: error: 'a.mcap' is not there\n  hint: look for it\n");
  const Outcome odd = outcomeOf({"play", "odd"});
  EXPECT_EQ(odd.code, kFailed);
  EXPECT_EQ(odd.said, "pongsim: error: it is odd\n");
}

TEST(ProgramsCommandLine, HelpsInAllTheWaysThatPongsimDoes) {
  const Outcome help = outcomeOf({"--help"});
  EXPECT_EQ(help.code, kDone);
  for (const char* part : {"Tests.", "pongsim test", "ACTION", "Actions:", "List topics", "The end."}) {
    EXPECT_NE(help.printed.find(part), std::string::npos) << part;
  }
  const std::string ofAction = outcomeOf({"topics", "--help"}).printed;
  EXPECT_NE(ofAction.find("--world WORLD"), std::string::npos);
  EXPECT_EQ(outcomeOf({"help", "topics"}).printed, ofAction);
  EXPECT_EQ(outcomeOf({"topics", "help"}).printed, ofAction);
  EXPECT_EQ(outcomeOf({"help"}).printed, help.printed);
}

TEST(ProgramsCommandLine, ReadsTheWordsThatTheProgramMakesOfThem) {
  const auto words = [](std::vector<std::string> given, const CLI::App&) {
    if (given.front() == "upload") throw UsageError("'upload' is not supported");
    if (given.front() == "list") given.front() = "topics";
    return given;
  };
  const Program program{.name = "pongsim test", .commands = kActions, .words = words};
  EXPECT_EQ(outcomeOf({"list"}, program).code, 42);
  EXPECT_EQ(outcomeOf({"upload"}, program).said, "pongsim: error: 'upload' is not supported\n");
}

}  // namespace
}  // namespace pongsim::cli
