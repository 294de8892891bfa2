#include <gtest/gtest.h>

#include <cctype>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "integration/program.hh"
#include "support/fortress_worlds.hh"
#include "support/process.hh"
#include "support/regex.hh"
#include "support/temp_folder.hh"
#include "support/test_domain.hh"

namespace pongsim {
namespace {

/// Timeout for a page with dozens of commands, on a machine that is busy with other tests.
constexpr std::chrono::seconds kPage{280};

/// A page whose commands tools/cli-tour runs with this build's pongsim.
class Tour : public testing::TestWithParam<const char*> {};

TEST_P(Tour, GoesAsThePageSays) {
  test::testDomain();
  test::Process tour({"tools/cli-tour", GetParam()},
                     {.environment = {{"PONGSIM", PONGSIM_PROGRAM}}, .folder = test::projectFolder()});
  const std::optional<int> code = tour.wait(kPage);
  ASSERT_TRUE(code.has_value()) << tour.output() << tour.error();
  if (*code == 77) GTEST_SKIP() << tour.error();
  EXPECT_EQ(*code, 0) << tour.output() << tour.error();
}

INSTANTIATE_TEST_SUITE_P(Documentation, Tour,
                         testing::Values("README.md", "docs/ci.md", "docs/cli.md", "docs/gazebo.md",
                                         "docs/installation.md", "docs/lockstep.md", "docs/logs.md", "docs/plugins.md",
                                         "docs/ros2.md", "docs/security.md", "docs/sensors.md", "docs/tutorials.md"),
                         [](const auto& page) {
                           std::string name;
                           for (const char letter : std::string(page.param)) {
                             if (std::isalnum(static_cast<unsigned char>(letter)) != 0) name += letter;
                           }
                           return name;
                         });

/// @return Result and output of tools/cli-tour for a page with this text.
test::Outcome tourOf(const std::string& text) {
  test::testDomain();
  const test::TempFolder folder;
  std::ofstream(folder.path() / "page.md") << text;
  test::Process tour({"tools/cli-tour", (folder.path() / "page.md").string()},
                     {.environment = {{"PONGSIM", PONGSIM_PROGRAM}}, .folder = test::projectFolder()});
  const std::optional<int> code = tour.wait();
  return {code.value_or(-1), tour.output(), tour.error()};
}

TEST(TourItself, FailsWhereAPageIsWrong) {
  EXPECT_EQ(tourOf("    pongsim --version\n<!-- tour: 1 prints ^pongsim \\d -->\n").exitCode, 0);
  const test::Outcome other = tourOf("    pongsim --version\n<!-- tour: 1 prints ^pingsim -->\n");
  EXPECT_EQ(other.exitCode, 1);
  EXPECT_NE(other.error.find("did not print '^pingsim'"), std::string::npos) << other.error;
  EXPECT_EQ(tourOf("    pongsim frobnicate\n").exitCode, 1);
  EXPECT_EQ(tourOf("    pongsim frobnicate\n<!-- tour: 1 exits 2 -->\n").exitCode, 0);
  EXPECT_EQ(tourOf("<!-- tour: needs no/such/world.sdf -->\n    false\n").exitCode, 77);
  EXPECT_EQ(tourOf("<!-- tour: skip it fails -->\n    false\n").exitCode, 0);
  EXPECT_EQ(tourOf("    <world/>\n    false\n\nA file:\n\n    - false\n\nMore:\n\n    key: value\n").exitCode, 0);
}

/// A script that uses this build's pongsim.
class DocumentationTest : public testing::Test {
 protected:
  void run(const std::string& script) {
    const std::string path = std::filesystem::path(PONGSIM_PROGRAM).parent_path().string();
    test::Process shell({"bash", "-em", "-c", "export PATH=" + path + ":$PATH\n" + script},
                        {.environment = {}, .folder = test::projectFolder()});
    const std::optional<int> code = shell.wait(kPage);
    ASSERT_TRUE(code.has_value()) << shell.output() << shell.error();
    EXPECT_EQ(*code, 0) << script << "\n" << shell.output() << shell.error();
    output_ = shell.output();
  }

  const int domain_ = test::testDomain();
  std::string output_;
};

TEST_F(DocumentationTest, SystemsPageSaysWhatTheSystemsSay) {
  run("PONGSIM=" PONGSIM_PROGRAM " tools/systems-table --print");
  std::ifstream stream(test::projectFolder() / "docs/systems.md");
  const std::string page(std::istreambuf_iterator<char>(stream), {});
  EXPECT_EQ(page, output_) << "tools/systems-table writes it anew";
}

TEST(Documentation, LinksLeadSomewhere) {
  namespace fs = std::filesystem;
  const test::Regex link("\\]\\(([^)#:]+)(#[^)]*)?\\)");
  int links = 0;
  std::vector<fs::path> files = {test::projectFolder() / "README.md", test::projectFolder() / "CHANGELOG.md"};
  for (const char* folder : {"docs", "plugins", "src"}) {
    for (const auto& entry : fs::recursive_directory_iterator(test::projectFolder() / folder)) {
      if (entry.path().extension() == ".md") files.push_back(entry.path());
    }
  }
  for (const fs::path& file : files) {
    std::ifstream stream(file);
    const std::string text(std::istreambuf_iterator<char>(stream), {});
    for (const test::Regex::Match& found : link.allIn(text)) {
      EXPECT_TRUE(fs::exists(file.parent_path() / found[1])) << file << ": " << found[1];
      ++links;
    }
  }
  EXPECT_GE(links, 8);
}

}  // namespace
}  // namespace pongsim
