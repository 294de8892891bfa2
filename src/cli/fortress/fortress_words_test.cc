#include "cli/fortress/fortress_words.hh"

#include <gtest/gtest.h>

#include <array>

namespace pongsim::cli {
namespace {

using namespace std::string_view_literals;

TEST(FortressWords, SayWhichPackageBringsACommand) {
  for (const char* name : {"log", "fuel", "ros2"}) {
    const auto advice = adviceOnCommand(name);
    ASSERT_TRUE(advice.has_value()) << name;
    EXPECT_EQ(advice->message,
              "'" + std::string(name) + "' is in the package pongsim-" + name + ", which is not installed");
    EXPECT_EQ(advice->hint, "apt-get install pongsim-" + std::string(name));
  }
}

TEST(FortressWords, SayWhatToUseInPlaceOfACommand) {
  for (const char* name : {"gui", "launch", "param", "gazebo", "sim"})
    EXPECT_TRUE(adviceOnCommand(name).has_value()) << name;
  EXPECT_EQ(adviceOnCommand("simulate"), std::nullopt);
}

TEST(FortressWords, SayWhichPackageBringsAnOption) {
  constexpr std::array kOwn = {"--paused"sv};
  for (const char* option : {"--record", "--record-path", "--record-resources", "--record-topic", "--record-period",
                             "--log-overwrite", "--log-compress", "--playback"}) {
    const auto advice = adviceOnOption("run", option, kOwn);
    ASSERT_TRUE(advice.has_value()) << option;
    EXPECT_EQ(advice->hint, "apt-get install pongsim-log") << option;
  }
  EXPECT_EQ(adviceOnOption("topic", "--record", kOwn), std::nullopt);
}

TEST(FortressWords, LeaveAWrongOptionOfAnInstalledPackageToOthers) {
  constexpr std::array kWithPackage = {"--paused"sv, "--ros2"sv, "--ros2-topic"sv};
  EXPECT_EQ(adviceOnOption("run", "--ros2-topci", kWithPackage), std::nullopt);
  EXPECT_TRUE(adviceOnOption("run", "--record", kWithPackage).has_value());
}

TEST(FortressWords, SayWhereTheVersionIsTold) {
  for (const char* option : {"--version", "--versions", "--force-version"}) {
    EXPECT_TRUE(adviceOnOption("topic", option, {}).has_value()) << option;
  }
}

}  // namespace
}  // namespace pongsim::cli
