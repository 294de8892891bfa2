#include "log/command/topic_choice.hh"

#include <gtest/gtest.h>

#include "shared/program/failure.hh"

namespace pongsim::log {
namespace {

TEST(TopicChoice, KnowsNamesFromExpressions) {
  const TopicChoice choice({"/odom", "/model/.*", "world.*"});
  EXPECT_EQ(choice.names(), std::vector<std::string>{"/odom"});
  EXPECT_TRUE(choice.has("/odom"));
  EXPECT_TRUE(choice.has("/model/box/pose"));
  EXPECT_FALSE(choice.has("/odometry"));
  // expressions match whole names, as with ign
  EXPECT_FALSE(choice.has("/world/a"));
}

TEST(TopicChoice, IsAllWithoutWords) {
  EXPECT_TRUE(TopicChoice({}).has("/anything"));
  EXPECT_TRUE(TopicChoice({}).names().empty());
}

TEST(TopicChoice, RefusesWhatIsNoExpression) { EXPECT_THROW(TopicChoice({"/a(b"}), cli::UsageError); }

}  // namespace
}  // namespace pongsim::log
