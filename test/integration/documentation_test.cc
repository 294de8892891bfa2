#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "integration/program.hh"
#include "support/fortress_worlds.hh"
#include "support/process.hh"
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

TEST_F(DocumentationTest, ExamplesOfTheTopicCommandWork) {
  std::string script = "trap 'kill $(jobs -p) 2>/dev/null || true' EXIT\npongsim run worlds/pong_world.sdf &\n";
  int examples = 0;
  for (const std::string& line : codeLines("docs/cli.md", "## pongsim topic")) {
    if (examples++ == 0) script += "pongsim topic -e -t /clock -n 1 >/dev/null\n";
    script += line + "\n";
  }
  EXPECT_GE(examples, 5);
  run(script);
  EXPECT_NE(output_.find("{\"system\":{"), std::string::npos) << output_;
}

TEST_F(DocumentationTest, ExamplesOfTheSdfCommandWork) {
  std::string script = "set -e\n";
  for (const std::string& line : codeLines("docs/cli.md", "## pongsim sdf --check FILE...")) script += line + "\n";
  run(script);
  EXPECT_TRUE(output_.starts_with("Valid.\n[")) << output_;
}

}  // namespace
}  // namespace pongsim
