#include "cli/fortress/ign_arguments.hh"

#include <gtest/gtest.h>

#include "shared/program/failure.hh"

namespace pongsim::cli {
namespace {

using Words = std::vector<std::string>;

TEST(IgnArguments, AreForALinkOfThatName) {
  for (const char* yes : {"ign", "gz", "/usr/bin/ign", "./gz"}) EXPECT_TRUE(isCalledAsIgn(yes)) << yes;
  for (const char* no : {"pongsim", "/ign/pongsim", "sign", "", "ign/"}) EXPECT_FALSE(isCalledAsIgn(no)) << no;
}

Words wordsOf(const Words& arguments) {
  const IgnLine line = fromIgnArguments(arguments);
  EXPECT_FALSE(line.text.has_value());
  return line.arguments;
}

TEST(IgnArguments, RunAWorld) {
  EXPECT_EQ(wordsOf({"gazebo", "-s", "-r", "shapes.sdf"}), (Words{"run", "-s", "-r", "shapes.sdf"}));
  EXPECT_EQ(wordsOf({"sim", "shapes.sdf", "--iterations", "5"}),
            (Words{"run", "shapes.sdf", "--iterations", "5", "--paused"}));
  EXPECT_EQ(wordsOf({"gazebo", "--help"}), (Words{"run", "--help"}));
  EXPECT_EQ(wordsOf({"help", "gazebo"}), (Words{"run", "--help"}));
  EXPECT_EQ(wordsOf({"gazebo", "levels.sdf", "-r", "--levels"}), (Words{"run", "levels.sdf", "-r", "--levels"}));
}

TEST(IgnArguments, NeedNoNumberBehindTheVerbosity) {
  EXPECT_EQ(wordsOf({"gazebo", "-r", "-v", "4", "a.sdf"}), (Words{"run", "-r", "-v", "4", "a.sdf"}));
  EXPECT_EQ(wordsOf({"gazebo", "-r", "a.sdf", "-v"}), (Words{"run", "-r", "a.sdf", "-v", "3"}));
  EXPECT_EQ(wordsOf({"gazebo", "-v", "-r", "a.sdf"}), (Words{"run", "-v", "3", "-r", "a.sdf"}));
  EXPECT_EQ(wordsOf({"gazebo", "-r", "--verbose", "a.sdf"}), (Words{"run", "-r", "--verbose", "3", "a.sdf"}));
  EXPECT_EQ(wordsOf({"gazebo", "-r", "--verbose=2", "a.sdf"}), (Words{"run", "-r", "--verbose=2", "a.sdf"}));
}

TEST(IgnArguments, MayBeJoined) {
  EXPECT_EQ(wordsOf({"gazebo", "-sr", "a.sdf"}), (Words{"run", "-sr", "a.sdf"}));
  EXPECT_EQ(wordsOf({"gazebo", "-s", "-rv4", "a.sdf"}), (Words{"run", "-s", "-rv4", "a.sdf"}));
  EXPECT_EQ(wordsOf({"gazebo", "-srv", "a.sdf"}), (Words{"run", "-srv", "3", "a.sdf"}));
  EXPECT_EQ(wordsOf({"gazebo", "-sv4", "a.sdf"}), (Words{"run", "-sv4", "a.sdf", "--paused"}));
}

TEST(IgnArguments, TellOfVersionsWithoutRunningAnything) {
  EXPECT_EQ(fromIgnArguments({"gazebo", "--versions"}).text, "6\n");
  EXPECT_EQ(fromIgnArguments({"topic", "--versions"}).text, "11\n");
  EXPECT_EQ(fromIgnArguments({"sdf", "--versions"}).text, "12\n");
  EXPECT_EQ(fromIgnArguments({"gazebo", "--version"}).text,
            "pongsim " PONGSIM_VERSION ", which does what 'gazebo' of version 6 does\n");
  for (const char* word : {"-v", "--version"}) {
    EXPECT_TRUE(fromIgnArguments({"topic", word}).text.has_value()) << word;
    EXPECT_TRUE(fromIgnArguments({"service", "-l", word}).text.has_value()) << word;
  }
  EXPECT_NE(fromIgnArguments({"--commands"}).text->find("\ngazebo\n"), std::string::npos);
}

TEST(IgnArguments, MayForceTheVersionThatThisIs) {
  EXPECT_EQ(wordsOf({"gazebo", "-r", "a.sdf", "--force-version", "6"}), (Words{"run", "-r", "a.sdf"}));
  EXPECT_EQ(wordsOf({"gazebo", "--force-version=6.16.0", "-r", "a.sdf"}), (Words{"run", "-r", "a.sdf"}));
  EXPECT_EQ(wordsOf({"topic", "--force-version", "11", "-l"}), (Words{"topic", "-l"}));
  EXPECT_THROW(fromIgnArguments({"gazebo", "-r", "a.sdf", "--force-version", "7"}), UsageError);
  EXPECT_THROW(fromIgnArguments({"gazebo", "a.sdf", "--force-version=61"}), UsageError);
  EXPECT_THROW(fromIgnArguments({"gazebo", "--force-version"}), UsageError);
}

TEST(IgnArguments, AreOtherwiseTheSame) {
  const Words topic = {"topic", "-t", "/cmd_vel", "-m", "ignition.msgs.Twist", "-p", "linear: {x: 0.5}"};
  EXPECT_EQ(wordsOf(topic), topic);
  EXPECT_EQ(wordsOf({"service", "--help-all"}), (Words{"service", "--help"}));
  EXPECT_EQ(wordsOf({"plugin", "-i", "-v", "-p", "lib.so"}), (Words{"plugin", "-i", "-p", "lib.so"}));
  EXPECT_EQ(wordsOf({"msg", "-l"}), (Words{"msg", "-l", "--as-ign"}));
  EXPECT_EQ(wordsOf({"launch", "a.ign"}), (Words{"launch", "a.ign"}));
  EXPECT_EQ(wordsOf({}), Words());
}

}  // namespace
}  // namespace pongsim::cli
