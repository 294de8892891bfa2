#include "cli/ign_arguments.hh"

#include <gtest/gtest.h>

#include "cli/console.hh"

namespace pongsim::cli {
namespace {

using Words = std::vector<std::string>;

TEST(IgnArguments, AreForALinkOfThatName) {
  for (const char* yes : {"ign", "gz", "/usr/bin/ign", "./gz"}) EXPECT_TRUE(isCalledAsIgn(yes)) << yes;
  for (const char* no : {"pongsim", "/ign/pongsim", "sign", "", "ign/"}) EXPECT_FALSE(isCalledAsIgn(no)) << no;
}

TEST(IgnArguments, RunAWorld) {
  EXPECT_EQ(fromIgnArguments({"gazebo", "-s", "-r", "shapes.sdf"}), (Words{"run", "-r", "shapes.sdf"}));
  EXPECT_EQ(fromIgnArguments({"sim", "shapes.sdf", "--iterations", "5"}),
            (Words{"run", "shapes.sdf", "--iterations", "5", "--paused"}));
  EXPECT_EQ(fromIgnArguments({"gazebo", "-r", "-v", "4", "a.sdf"}), (Words{"run", "-r", "-v", "4", "a.sdf"}));
  EXPECT_EQ(fromIgnArguments({"gazebo", "-r", "a.sdf", "-v"}), (Words{"run", "-r", "a.sdf", "-v", "3"}));
  EXPECT_EQ(fromIgnArguments({"gazebo", "-v", "-r", "a.sdf"}), (Words{"run", "-v", "3", "-r", "a.sdf"}));
  EXPECT_EQ(fromIgnArguments({"gazebo", "--help"}), (Words{"run", "--help"}));
  EXPECT_EQ(fromIgnArguments({"gazebo", "levels.sdf", "-r", "--levels"}),
            (Words{"run", "levels.sdf", "-r", "--levels"}));
  EXPECT_THROW(fromIgnArguments({"gazebo", "-g"}), UsageError);
  for (const char* word : {"--network-role=primary", "--network-role", "--network-secondaries"}) {
    EXPECT_THROW(fromIgnArguments({"gazebo", "a.sdf", word}), UsageError) << word;
  }
}

TEST(IgnArguments, AreOtherwiseTheSame) {
  const Words topic = {"topic", "-t", "/cmd_vel", "-m", "ignition.msgs.Twist", "-p", "linear: {x: 0.5}"};
  EXPECT_EQ(fromIgnArguments(topic), topic);
  EXPECT_EQ(fromIgnArguments({}), Words());
}

}  // namespace
}  // namespace pongsim::cli
