#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include "integration/program.hh"
#include "support/fortress_worlds.hh"
#include "support/process.hh"
#include "support/temp_folder.hh"
#include "support/test_domain.hh"

namespace pongsim {
namespace {

/// @return The lines of a Markdown file's code blocks (indented by four spaces), without the indentation; with a
/// heading, of those below it only.
std::vector<std::string> codeLines(const std::string& file, const std::string& heading = "") {
  std::ifstream stream(test::projectFolder() / file);
  EXPECT_TRUE(stream.is_open()) << file;
  std::vector<std::string> lines;
  bool below = heading.empty();
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("#") && !heading.empty()) below = line == heading;
    if (below && line.starts_with("    ")) lines.push_back(line.substr(4));
  }
  return lines;
}

/// Runs a script as an interactive shell would, with this build's pongsim found first.
class DocumentationTest : public testing::Test {
 protected:
  void run(const std::string& script) {
    const std::string path = std::filesystem::path(PONGSIM_PROGRAM).parent_path().string();
    test::Process shell({"bash", "-em", "-c", "export PATH=" + path + ":$PATH\n" + script},
                        {.environment = {}, .folder = test::projectFolder()});
    const std::optional<int> code = shell.wait();
    ASSERT_TRUE(code.has_value()) << shell.output() << shell.error();
    EXPECT_EQ(*code, 0) << script << "\n" << shell.output() << shell.error();
    output_ = shell.output();
  }

  const int domain_ = test::testDomain();
  std::string output_;
};

TEST_F(DocumentationTest, TutorialOfTheReadmeWorksLineByLine) {
  std::string script = "trap 'kill $(jobs -p) 2>/dev/null || true' EXIT\n";
  for (const std::string& line : codeLines("README.md", "## The tutorial in ten lines")) {
    if (line.starts_with("export PATH=")) continue;
    script += line + "\n";
    // Somebody who types is slower than the simulator starts.
    if (line.find('&') != std::string::npos) script += "pongsim topic -e -t /clock -n 1 >/dev/null\n";
  }
  ASSERT_NE(script.find("pongsim run worlds/pong_world.sdf &"), std::string::npos);
  run(script);
  EXPECT_NE(output_.find("/model/pong_bot/odometry\n"), std::string::npos) << output_;
  EXPECT_NE(output_.find("value: \"pong_bot/odom\"\n"), std::string::npos) << output_;
  EXPECT_NE(output_.find("name: \"pong_bot\"\n"), std::string::npos) << output_;
  EXPECT_NE(output_.find("state hash: "), std::string::npos) << output_;
}

TEST_F(DocumentationTest, ExamplesOfTheOtherCommandsWork) {
  std::string script =
      "trap 'kill $(jobs -p) 2>/dev/null || true' EXIT\npongsim run worlds/pong_world.sdf &\n"
      "pongsim topic -e -t /clock -n 1 >/dev/null\n";
  for (const char* command : {"topic", "service", "world", "key", "msg", "plugin", "completion"}) {
    const std::vector<std::string> examples = codeLines("docs/cli.md", std::string("## pongsim ") + command);
    EXPECT_FALSE(examples.empty()) << command;
    for (const std::string& line : examples) script += line + "\n";
  }
  run(script);
  EXPECT_NE(output_.find("\ndata: true\n"), std::string::npos) << output_;
  EXPECT_NE(output_.find(" iterations, paused\n"), std::string::npos) << output_;
  EXPECT_NE(output_.find("{\"system\":{"), std::string::npos) << output_;
}

TEST_F(DocumentationTest, ExamplesOfIgnWork) {
  const test::TempFolder home;
  std::string script = "trap 'kill $(jobs -p) 2>/dev/null || true' EXIT\nexport HOME=" + home.path().string() + "\n";
  for (const std::string& line : codeLines("docs/cli.md", "## As `ign` or `gz`")) {
    script += line + "\n";
    if (line.ends_with('&')) script += "pongsim topic wait -t /clock\n";
  }
  run(script + "ign topic -l\n");
  EXPECT_NE(output_.find("/cmd_vel\n"), std::string::npos) << output_;
}

TEST_F(DocumentationTest, SystemsPageSaysWhatTheSystemsSay) {
  run("PONGSIM=" PONGSIM_PROGRAM " tools/systems-table --print");
  std::ifstream stream(test::projectFolder() / "docs/systems.md");
  const std::string page(std::istreambuf_iterator<char>(stream), {});
  EXPECT_EQ(page, output_) << "tools/systems-table writes it anew";
}

TEST(Documentation, LinksLeadSomewhere) {
  namespace fs = std::filesystem;
  const std::regex link("\\]\\(([^)#:]+)(#[^)]*)?\\)");
  int links = 0;
  std::vector<fs::path> files = {test::projectFolder() / "README.md"};
  for (const char* folder : {"docs", "plugins", "src"}) {
    for (const auto& entry : fs::recursive_directory_iterator(test::projectFolder() / folder)) {
      if (entry.path().extension() == ".md") files.push_back(entry.path());
    }
  }
  for (const fs::path& file : files) {
    std::ifstream stream(file);
    const std::string text(std::istreambuf_iterator<char>(stream), {});
    for (std::sregex_iterator found(text.begin(), text.end(), link), end; found != end; ++found, ++links) {
      EXPECT_TRUE(fs::exists(file.parent_path() / (*found)[1].str())) << file << ": " << (*found)[1];
    }
  }
  EXPECT_GE(links, 8);
}

TEST_F(DocumentationTest, ExamplesOfTheSdfCommandWork) {
  std::string script = "set -e\n";
  for (const std::string& line : codeLines("docs/cli.md", "## pongsim sdf --check FILE...")) script += line + "\n";
  run(script);
  EXPECT_TRUE(output_.starts_with("Valid.\n[")) << output_;
}

}  // namespace
}  // namespace pongsim
