#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "integration/program.hh"
#include "support/regex.hh"
#include "support/temp_folder.hh"

namespace pongsim::test {
namespace {

/// Runs a world with this text, and expects that it is refused with a line on stderr that matches `pattern`.
void expectRefused(const std::string& text, const std::string& pattern) {
  const TempFolder folder;
  const std::string file = folder.write("world.sdf", text).string();
  const Outcome outcome = runToEnd({"run", file, "--iterations", "1"});
  EXPECT_EQ(outcome.exitCode, 1) << outcome.error;
  EXPECT_EQ(outcome.output, "");
  EXPECT_TRUE(Regex("world\\.sdf" + pattern).isIn(outcome.error)) << outcome.error;
  EXPECT_TRUE(Regex("pongsim: [0-9]+ errors?\n$").isIn(outcome.error)) << outcome.error;
}

TEST(BadWorld, IsNotThere) {
  const Outcome outcome = runToEnd({"run", "/nowhere/missing.sdf"});
  EXPECT_EQ(outcome.exitCode, 1);
  EXPECT_TRUE(outcome.error.starts_with("/nowhere/missing.sdf: error: ")) << outcome.error;
}

TEST(BadWorld, IsAFolder) {
  const TempFolder folder;
  EXPECT_EQ(runToEnd({"run", folder.path().string()}).exitCode, 1);
}

TEST(BadWorld, IsEmpty) { expectRefused("", ": error: |:1:\\d+: error: |:1: error: "); }

TEST(BadWorld, HasBrokenXml) {
  expectRefused("<sdf version='1.9'>\n<world name='w'>\n<model name='m'>\n</world>\n</sdf>\n", ":[34]:[0-9:]* error: ");
}

TEST(BadWorld, HasAJointToALinkThatIsNotThere) {
  expectRefused(
      "<sdf version='1.9'><world name='w'><model name='m'>\n<link name='base'/>\n"
      "<joint name='j' type='revolute'>\n<parent>base</parent><child>whel</child><axis/>\n</joint>\n"
      "</model></world></sdf>",
      ":[34]:\\d+: error: .*whel");
}

TEST(BadWorld, AsksForAPluginThatIsNotThere) {
  const TempFolder folder;
  const std::string file =
      folder
          .write("world.sdf",
                 "<sdf version='1.9'><world name='w'>\n<plugin filename='libno-such-thing.so' name='none::Such'/>\n"
                 "<plugin filename='ignition-gazebo-physics-system' name=''/></world></sdf>")
          .string();
  const Outcome lenient = runToEnd({"run", file, "--iterations", "1"});
  EXPECT_EQ(lenient.exitCode, 0) << lenient.error;
  EXPECT_TRUE(Regex("world\\.sdf:2:\\d+: warning: .*no-such-thing").isIn(lenient.error)) << lenient.error;
  for (const std::vector<std::string>& strict :
       {std::vector<std::string>{"run", "--strict", file}, {"sdf", "--check", "--strict", file}}) {
    const Outcome outcome = runToEnd(strict);
    EXPECT_EQ(outcome.exitCode, 1) << outcome.error;
    EXPECT_TRUE(Regex("world\\.sdf:2:\\d+: error: .*no-such-thing").isIn(outcome.error)) << outcome.error;
  }
}

TEST(BadWorld, IsNoTextAtAll) {
  std::string bytes(100'000, '\0');
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i * 31 % 251);
  expectRefused(bytes, ".*error: ");
}

}  // namespace
}  // namespace pongsim::test
