// Failing third-party systems.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "integration/program.hh"
#include "support/temp_folder.hh"

namespace pongsim::test {
namespace {

class FaultTest : public testing::Test {
 protected:
  Outcome runWith(const std::string& fault, const std::vector<std::string>& options = {}) {
    const std::filesystem::path world =
        folder_.write("world.sdf", R"(<sdf version="1.9"><world name="w">
      <plugin filename="ignition-gazebo-physics-system" name="ignition::gazebo::systems::Physics"/>
      <model name="m"><link name="l"/><joint name="j" type="revolute"><parent>world</parent><child>l</child>
        <axis><xyz>0 0 1</xyz></axis></joint>
        <plugin filename="misbehaving" name="test::Misbehaving"><fault>)" +
                                       fault + "</fault></plugin></model></world></sdf>");
    setenv("PONGSIM_PLUGIN_PATH", PONGSIM_TEST_SYSTEMS, 1);
    std::vector<std::string> arguments = {"run", world.string(), "-z", "0", "--iterations", "100"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return runToEnd(arguments);
  }

  TempFolder folder_;
};

TEST_F(FaultTest, OfASystemIsNamedAndTheWorldGoesOn) {
  const std::pair<const char*, const char*> cases[] = {
      {"throw", "error: misbehaving of m: failed in preUpdate: no more; it is switched off"},
      {"nan",
       "error: misbehaving of m: failed in preUpdate: joint 'j' was given a command that is not a finite number; it is "
       "switched off"},
      {"message", "error: misbehaving of m: failed in a message or request: told to; it is switched off"}};
  for (const auto& [fault, message] : cases) {
    const Outcome outcome = runWith(fault);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
    const std::vector<std::string> said = lines(outcome.error);
    ASSERT_EQ(said.size(), 2U) << outcome.error;
    EXPECT_EQ(said[1].substr(0, said[1].find(" (")), message);
    EXPECT_TRUE(said[1].ends_with("world.sdf:5:9)")) << said[1];
  }
}

TEST_F(FaultTest, EndsTheRunIfThatIsToBeStrict) {
  const Outcome outcome = runWith("throw", {"--strict"});
  EXPECT_EQ(outcome.exitCode, 1);
  EXPECT_EQ(lines(outcome.error).back(), "pongsim: error: misbehaving of m failed in preUpdate: no more");
  EXPECT_EQ(runWith("message", {"--strict"}).exitCode, 1);
}

TEST_F(FaultTest, OfTheProcessIsPutDownToTheSystem) {
  const Outcome outcome = runWith("crash");
  // 139, or a sanitizer's exit code
  EXPECT_GT(outcome.exitCode, 0) << outcome.error;
  EXPECT_NE(outcome.error.find("pongsim: error: crashed with SIGSEGV in the system misbehaving of m, in preUpdate\n"),
            std::string::npos)
      << outcome.error;
}

TEST_F(FaultTest, OfAFileIsAnErrorIfThatIsToBeStrict) {
  EXPECT_EQ(runWith("dance").exitCode, 0);
  const Outcome outcome = runWith("dance", {"--strict"});
  EXPECT_EQ(outcome.exitCode, 1);
  EXPECT_NE(outcome.error.find(": error: misbehaving of m is left out: <fault> is 'dance'"), std::string::npos)
      << outcome.error;
}

}  // namespace
}  // namespace pongsim::test
