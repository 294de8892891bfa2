#include "cli/fortress/ign_arguments.hh"

#include <gtest/gtest.h>

#include "shared/program/failure.hh"

namespace pongsim::cli {
namespace {

using Words = std::vector<std::string>;

TEST(IgnArguments, AreForALinkOfThatName) {
  for (const char* name : {"ign", "/usr/bin/ign"}) EXPECT_EQ(calledAs(name), GazeboProgram::kIgn) << name;
  for (const char* name : {"gz", "./gz"}) EXPECT_EQ(calledAs(name), GazeboProgram::kGz) << name;
  for (const char* no : {"pongsim", "/ign/pongsim", "sign", "gzip", "", "ign/"}) {
    EXPECT_EQ(calledAs(no), std::nullopt) << no;
  }
}

/// @return What a command line for `ign` or `gz` becomes.
Words wordsOf(const Words& arguments, GazeboProgram program = GazeboProgram::kIgn) {
  const IgnLine line = fromIgnArguments(program, arguments);
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
  EXPECT_EQ(fromIgnArguments(GazeboProgram::kIgn, {"gazebo", "--versions"}).text, "6\n");
  EXPECT_EQ(fromIgnArguments(GazeboProgram::kIgn, {"topic", "--versions"}).text, "11\n");
  EXPECT_EQ(fromIgnArguments(GazeboProgram::kIgn, {"sdf", "--versions"}).text, "12\n");
  EXPECT_EQ(fromIgnArguments(GazeboProgram::kIgn, {"gazebo", "--version"}).text,
            "pongsim " PONGSIM_VERSION ", which does what 'gazebo' of version 6 of Fortress does\n");
  for (const char* word : {"-v", "--version"}) {
    EXPECT_TRUE(fromIgnArguments(GazeboProgram::kIgn, {"topic", word}).text.has_value()) << word;
    EXPECT_TRUE(fromIgnArguments(GazeboProgram::kIgn, {"service", "-l", word}).text.has_value()) << word;
  }
  EXPECT_NE(fromIgnArguments(GazeboProgram::kIgn, {"--commands"}).text->find("\ngazebo\n"), std::string::npos);
}

TEST(IgnArguments, MayForceTheVersionThatThisIs) {
  EXPECT_EQ(wordsOf({"gazebo", "-r", "a.sdf", "--force-version", "6"}), (Words{"run", "-r", "a.sdf"}));
  EXPECT_EQ(wordsOf({"gazebo", "--force-version=6.16.0", "-r", "a.sdf"}), (Words{"run", "-r", "a.sdf"}));
  EXPECT_EQ(wordsOf({"topic", "--force-version", "11", "-l"}), (Words{"topic", "-l"}));
  EXPECT_THROW(fromIgnArguments(GazeboProgram::kIgn, {"gazebo", "-r", "a.sdf", "--force-version", "7"}), UsageError);
  EXPECT_THROW(fromIgnArguments(GazeboProgram::kIgn, {"gazebo", "a.sdf", "--force-version=61"}), UsageError);
  EXPECT_THROW(fromIgnArguments(GazeboProgram::kIgn, {"gazebo", "--force-version"}), UsageError);
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

TEST(GzArguments, AreThoseOfTheSameCommands) {
  EXPECT_EQ(wordsOf({"sim", "-s", "-rv4", "a.sdf", "--seed", "3"}, GazeboProgram::kGz),
            (Words{"run", "-s", "-rv4", "a.sdf", "--seed", "3"}));
  EXPECT_EQ(wordsOf({"sim", "-s", "a.sdf"}, GazeboProgram::kGz), (Words{"run", "-s", "a.sdf", "--paused"}));
  EXPECT_EQ(wordsOf({"log", "record", "--file", "a.tlog"}, GazeboProgram::kGz),
            (Words{"log", "record", "--file", "a.tlog"}));
  EXPECT_EQ(wordsOf({"model", "--list"}, GazeboProgram::kGz), (Words{"model", "--list", "--as-ign"}));
  EXPECT_EQ(wordsOf({"help", "sdf"}, GazeboProgram::kGz), (Words{"sdf", "--help"}));
}

TEST(GzArguments, NameTypesAsSinceGarden) {
  EXPECT_EQ(wordsOf({"topic", "-f", "-t", "/clock"}, GazeboProgram::kGz),
            (Words{"topic", "-f", "-t", "/clock", "--as-gz"}));
  EXPECT_EQ(wordsOf({"service", "-l"}, GazeboProgram::kGz), (Words{"service", "-l", "--as-gz"}));
  EXPECT_EQ(wordsOf({"msg", "-l"}, GazeboProgram::kGz), (Words{"msg", "-l", "--as-gz"}));
}

TEST(GzArguments, StandForAllVersionsFromGardenToJetty) {
  const auto textOf = [](const Words& arguments) { return fromIgnArguments(GazeboProgram::kGz, arguments).text; };
  EXPECT_EQ(textOf({"sim", "--versions"}), "10\n9\n8\n7\n");
  EXPECT_EQ(textOf({"sdf", "--versions"}), "16\n15\n14\n13\n");
  for (const Words& line : {Words{"sdf", "-v"}, Words{"model", "--version"}, Words{"topic", "-v"}}) {
    EXPECT_TRUE(textOf(line).has_value()) << line.front();
  }
  for (const char* version : {"7", "8", "8.9.0", "9", "10.1"}) {
    EXPECT_EQ(wordsOf({"sim", "-r", "a.sdf", "--force-version", version}, GazeboProgram::kGz),
              (Words{"run", "-r", "a.sdf"}));
  }
  for (const char* version : {"6", "11", "1", ""}) {
    EXPECT_THROW(wordsOf({"sim", "a.sdf", "--force-version", version}, GazeboProgram::kGz), UsageError) << version;
  }
}

}  // namespace
}  // namespace pongsim::cli
