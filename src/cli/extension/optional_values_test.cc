#include "cli/extension/optional_values.hh"

#include <gtest/gtest.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <string>
#include <vector>

namespace pongsim::cli {
namespace {

using Words = std::vector<std::string>;

/// A program whose command "run" has --web, of which the value may be left out, --flag and --file.
class OptionalValuesTest : public testing::Test {
 protected:
  OptionalValuesTest() {
    CLI::App* const run = program_.add_subcommand("run");
    run->add_option("--web", web_)->expected(0, 1);
    run->add_flag("--flag", flag_);
    run->add_option("--file", file_);
    program_.add_subcommand("model")->add_option("--link", link_)->expected(0, 1);
  }
  Words sorted(Words words) { return withOptionalValuesLast(std::move(words), program_); }

  CLI::App program_;
  std::string web_;
  bool flag_ = false;
  std::string file_;
  std::string link_;
};

TEST_F(OptionalValuesTest, PutsAnOptionBehindTheWordThatIsNotItsValue) {
  EXPECT_EQ(sorted({"run", "--web", "world.sdf"}), (Words{"run", "world.sdf", "--web"}));
  EXPECT_EQ(sorted({"run", "--web", "--flag", "world.sdf"}), (Words{"run", "--flag", "world.sdf", "--web"}));
}

TEST_F(OptionalValuesTest, LeavesAllElseWhereItIs) {
  for (const Words& words : {Words{"run", "--web", "8080", "world.sdf"}, Words{"run", "--web=8080", "world.sdf"},
                             Words{"run", "world.sdf", "--web"}, Words{"run", "--flag", "world.sdf"},
                             Words{"run", "--file", "a", "world.sdf"}, Words{"model", "--link", "wheel", "-m", "robot"},
                             Words{"walk", "--web", "world.sdf"}, Words{"run", "--web", "--", "world.sdf"},
                             Words{"run", "--", "--web", "world.sdf"}, Words{}}) {
    EXPECT_EQ(sorted(words), words);
  }
}

}  // namespace
}  // namespace pongsim::cli
