#include "shared/program/descriptor.hh"

#include <gtest/gtest.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "support/temp_folder.hh"

namespace pongsim::cli {
namespace {

class ProgramsDescriptor : public testing::Test {
 protected:
  std::string file(const std::string& text) {
    const std::string path = folder_.path() / "x.json";
    std::ofstream(path) << text;
    return path;
  }

  test::TempFolder folder_;
};

TEST_F(ProgramsDescriptor, HasTheActionsAndTheirOptionsAsTheyAreParsed) {
  CLI::App program("", "pongsim x");
  program.set_help_flag("-h,--help", "Print this help and exit");
  bool all = false;
  std::string output;
  CLI::App* list = program.add_subcommand("list", "List\nthem");
  list->add_option("FILE", output, "An argument");
  list->add_flag("-a,--all", all, "All of them");
  list->add_option("-o,--output,--file", output, "Where to")->type_name("FILE");
  list->add_flag("--secret", all)->group("");
  program.add_subcommand("fetch", "For other programs")->group("");
  const auto json = nlohmann::json::parse(descriptorWithActions(
      file(R"({"run": {"a": 1}, "command": {"name": "x", "examples": ["pongsim x list"]}})"), program));
  EXPECT_EQ(json, nlohmann::json::parse(R"({
      "run": {"a": 1},
      "command": {"name": "x", "examples": ["pongsim x list"], "actions": [
        {"name": "list", "help": "List them", "options": [
          {"option": "--all", "help": "All of them"},
          {"option": "--output", "value": "FILE", "help": "Where to"},
          {"option": "--file", "value": "FILE", "help": "Where to"}]}]}})"));
}

TEST_F(ProgramsDescriptor, MustBeJson) {
  const CLI::App program("", "pongsim x");
  EXPECT_THROW(descriptorWithActions(file("{"), program), std::exception);
  EXPECT_THROW(descriptorWithActions(folder_.path() / "none.json", program), std::exception);
}

}  // namespace
}  // namespace pongsim::cli
