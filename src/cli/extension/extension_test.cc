#include "cli/extension/extension.hh"

#include <gtest/gtest.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fstream>
#include <stdexcept>
#include <string>

#include "shared/program/failure.hh"
#include "support/temp_folder.hh"

namespace pongsim::cli {
namespace {

constexpr const char* kDescriptor = R"({
  "run": {
    "system": {"filename": "pongsim-x-system", "name": "pongsim::systems::X"},
    "options": [
      {"option": "--x", "help": "Be X"},
      {"option": "--x-only", "help": "Nothing else", "element": "all", "sets": "false"},
      {"option": "--x-file", "value": "FILE", "help": "From there", "element": "file", "file": true},
      {"option": "--x-topic", "value": "TOPIC", "help": "That one", "element": "topic", "repeated": true}
    ]
  },
  "command": {"name": "x", "help": "Look at X", "program": "pongsim-x",
              "actions": [{"name": "topics", "help": "List them", "options": [{"option": "--all", "help": "All"}]}],
              "examples": ["pongsim x topics"]}
})";

class ExtensionTest : public testing::Test {
 protected:
  Extension read(const std::string& text) {
    std::ofstream(folder_.path() / "x.json") << text;
    return readExtension(folder_.path() / "x.json");
  }

  std::vector<Element> systemsOf(const std::string& arguments) {
    CLI::App command("", "run");
    RunAdditions additions;
    addRunOptions(command, read(kDescriptor), additions);
    command.parse(arguments);
    return additions.systems;
  }

  test::TempFolder folder_;
};

TEST_F(ExtensionTest, IsReadFromItsDescriptor) {
  const Extension extension = read(kDescriptor);
  EXPECT_EQ(extension.system.file, "pongsim-x-system");
  ASSERT_EQ(extension.runOptions.size(), 4U);
  EXPECT_TRUE(extension.runOptions[3].isRepeated);
  ASSERT_TRUE(extension.command.has_value());
  EXPECT_EQ(extension.command->actions.at(0).options.at(0).name, "--all");
}

TEST_F(ExtensionTest, ThatIsWrongSaysWhy) {
  for (const char* text :
       {"", "{", "[]", R"({"run": {}})", R"({"command": {"name": "x"}})",
        R"({"command": {"name": "x", "help": "", "program": "/bin/sh"}})",
        R"({"run": {"system": {"filename": "a", "name": "b"}, "options": [{"option": "x", "help": ""}]}})",
        R"({"run": {"system": {"filename": "a", "name": "b"},
            "options": [{"option": "--x", "help": "", "type": "number"}]}})",
        R"({"run": {"system": {"filename": "a", "name": "b"},
            "options": [{"option": "--x", "help": "", "value": "N", "type": "length"}]}})",
        R"({"run": {"system": {"filename": "a", "name": "b"},
            "options": [{"option": "--x", "help": "", "sets": "true"}]}})",
        R"({"run": {"system": {"filename": "a", "name": "b"},
            "options": [{"option": "--x", "help": "", "value": "NAME", "optional": true}]}})"}) {
    EXPECT_THROW(read(text), std::runtime_error) << text;
  }
}

TEST_F(ExtensionTest, AddsNoSystemUnlessAnOptionAsksForIt) { EXPECT_TRUE(systemsOf("").empty()); }

TEST_F(ExtensionTest, AddsItsSystemOnceWithWhatTheOptionsSay) {
  const std::vector<Element> systems = systemsOf("--x --x-topic /a --x-topic /b --x-file here.yaml");
  ASSERT_EQ(systems.size(), 1U);
  EXPECT_EQ(systems[0].attribute("filename")->value, "pongsim-x-system");
  EXPECT_EQ(systems[0].attribute("name")->value, "pongsim::systems::X");
  ASSERT_EQ(systems[0].childrenNamed("topic").size(), 2U);
  EXPECT_EQ(systems[0].childrenNamed("topic")[1]->text, "/b");
  EXPECT_EQ(systems[0].child("file")->text, std::filesystem::absolute("here.yaml").string());
}

TEST_F(ExtensionTest, AValueMayBeLeftOutWhereItIsOptional) {
  const Extension extension = read(R"({"run": {"system": {"filename": "a", "name": "b"}, "options": [
      {"option": "--x", "help": "", "value": "N", "type": "whole number", "optional": true, "element": "n"}]}})");
  const auto valueOf = [&extension](const std::string& arguments) {
    CLI::App command("", "run");
    RunAdditions additions;
    addRunOptions(command, extension, additions);
    command.parse(arguments);
    const Element* const element = additions.systems.at(0).child("n");
    return element == nullptr ? std::string("none") : element->text;
  };
  EXPECT_EQ(valueOf("--x"), "none");
  EXPECT_EQ(valueOf("--x 7"), "7");
  EXPECT_EQ(valueOf("--x=7"), "7");
  EXPECT_THROW(valueOf("--x seven"), UsageError);
}

TEST_F(ExtensionTest, AnOptionWithoutAValueMaySetOne) {
  const std::vector<Element> systems = systemsOf("--x-only");
  ASSERT_EQ(systems.size(), 1U);
  EXPECT_EQ(systems[0].child("all")->text, "false");
}

TEST_F(ExtensionTest, AValueOfAnotherTypeIsAWrongCommandLine) {
  const Extension extension = read(R"({
    "run": {"system": {"filename": "x", "name": "X"},
            "options": [{"option": "--rate", "value": "HZ", "type": "number", "least": 0, "help": "", "element": "a",
                         "repeated": true}]}})");
  const auto parse = [&](const char* arguments) {
    CLI::App command("", "run");
    RunAdditions additions;
    addRunOptions(command, extension, additions);
    command.parse(arguments);
    return additions;
  };
  EXPECT_EQ(parse("--rate 2").systems.at(0).child("a")->text, "2");
  EXPECT_THROW(parse("--rate x"), UsageError);
  EXPECT_THROW(parse("--rate 2 --rate=-1"), UsageError);
}

TEST_F(ExtensionTest, AFileWithoutANameIsAWrongCommandLine) {
  CLI::App command("", "run");
  RunAdditions additions;
  addRunOptions(command, read(kDescriptor), additions);
  // last word first
  EXPECT_THROW(command.parse(std::vector<std::string>{"", "--x-file"}), UsageError);
}

TEST_F(ExtensionTest, AnOptionMayBringTheWorldAndASystemOfItsOwn) {
  const Extension extension = read(R"({
    "run": {"system": {"filename": "x", "name": "X"},
            "options": [{"option": "--keep", "help": "", "element": "a", "sets": "1",
                         "implies": [{"element": "b", "sets": "2"}]},
                        {"option": "--play", "value": "PATH", "help": "", "element": "path",
                         "system": {"filename": "x", "name": "Y"}, "excludes": ["--keep"],
                         "world": {"program": "pongsim-x", "arguments": ["world"]}}]}})");
  const auto parse = [&](const char* arguments) {
    CLI::App command("", "run");
    RunAdditions additions;
    addRunOptions(command, extension, additions);
    command.parse(arguments);
    checkExcluded(command, extension);
    return additions;
  };
  const RunAdditions kept = parse("--keep");
  EXPECT_EQ(kept.systems.at(0).child("b")->text, "2");
  EXPECT_FALSE(kept.world);
  const RunAdditions played = parse("--play rec");
  EXPECT_EQ(played.systems.at(0).attribute("name")->value, "Y");
  EXPECT_EQ(played.worldOption, "--play");
  EXPECT_EQ(played.world->program, "pongsim-x");
  EXPECT_EQ(played.world->arguments, (std::vector<std::string>{"world", "rec"}));
  EXPECT_THROW(parse("--keep --play rec"), UsageError);
}

TEST_F(ExtensionTest, AnOptionWithASettingAsksForItToo) { EXPECT_EQ(systemsOf("--x-topic /a").size(), 1U); }

}  // namespace
}  // namespace pongsim::cli
