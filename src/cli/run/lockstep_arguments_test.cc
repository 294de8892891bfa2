#include "cli/run/lockstep_arguments.hh"

#include <gtest/gtest.h>

#include <CLI/App.hpp>
#include <chrono>
#include <string>
#include <vector>

#include "shared/program/failure.hh"

namespace pongsim::cli {
namespace {

/// @param words Behind each other, the last first, as CLI11 takes them.
std::optional<LockstepOptions> optionsOf(std::vector<std::string> words) {
  CLI::App app;
  LockstepArguments arguments;
  arguments.addTo(app);
  app.parse(std::move(words));
  return arguments.check();
}

std::string faultOf(std::vector<std::string> words) {
  try {
    optionsOf(std::move(words));
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

TEST(LockstepArguments, RefuseWhatIsNoTopicOrNumber) {
  EXPECT_NE(faultOf({"/cmd vel", "--lockstep"}).find("'/cmd vel' has a space"), std::string::npos);
  EXPECT_NE(faultOf({"/cmd:0", "--lockstep"}).find("where a whole number from 1 belongs"), std::string::npos);
  EXPECT_NE(faultOf({"/cmd:1:501", "--lockstep"}).find("at most 500 messages"), std::string::npos);
  EXPECT_NE(faultOf({"", "--lockstep"}), "");
  EXPECT_NE(faultOf({"soon", "--lockstep-timeout", "/a", "--lockstep"}).find("a number of seconds"), std::string::npos);
  EXPECT_NE(faultOf({"wait", "--lockstep-late", "/a", "--lockstep"}).find("end or continue, not 'wait'"),
            std::string::npos);
}

TEST(LockstepArguments, LeaveTheWorldBehindThemAlone) {
  CLI::App app;
  LockstepArguments arguments;
  arguments.addTo(app);
  std::string world;
  app.add_option("WORLD", world);
  app.parse(std::vector<std::string>{"world.sdf", "/lidar", "--lockstep-start", "/a", "--lockstep"});
  EXPECT_EQ(world, "world.sdf");
  EXPECT_EQ(arguments.check()->topics.size(), 1U);
}

TEST(LockstepArguments, BelongTogether) {
  EXPECT_FALSE(optionsOf({}));
  EXPECT_EQ(faultOf({"5", "--lockstep-timeout"}), "option '--lockstep-timeout' needs '--lockstep'");
  EXPECT_EQ(faultOf({"/a", "--lockstep-start"}), "option '--lockstep-start' needs '--lockstep'");
  const auto options = optionsOf({"continue", "--lockstep-late", "0.5", "--lockstep-timeout", "/lidar",
                                  "--lockstep-start", "/b:2", "--lockstep", "/a", "--lockstep"});
  ASSERT_TRUE(options);
  ASSERT_EQ(options->topics.size(), 2U);
  EXPECT_EQ(options->topics[0].name, "/a");
  EXPECT_EQ(options->topics[1].every, 2U);
  EXPECT_EQ(options->heard, std::vector<std::string>{"/lidar"});
  EXPECT_EQ(options->timeout, std::chrono::milliseconds(500));
  EXPECT_TRUE(options->goesOnWhenLate);
}

}  // namespace
}  // namespace pongsim::cli
