#include "cli/topic/topic_name.hh"

#include <gtest/gtest.h>

#include "pongsim/node.hh"
#include "shared/program/failure.hh"

namespace pongsim::cli {
namespace {

TEST(TopicName, GetsALeadingSlashAndLosesATrailingOne) {
  EXPECT_EQ(topicOption("cmd_vel"), "/cmd_vel");
  EXPECT_EQ(topicOption("/model/a::b/odometry/"), "/model/a::b/odometry");
}

TEST(TopicName, IsRefusedWhereItIsNone) {
  for (const char* name : {"", "/", "a b", "a//b", "~a", "a@b", "a:=b"}) {
    EXPECT_THROW(topicOption(name), UsageError) << name;
  }
}

TEST(TopicName, IsGuessedFromThoseThatAreThere) {
  std::vector<TopicInfo> topics(2);
  topics[0].name = "/clock";
  topics[1].name = "/cmd_vel";
  EXPECT_EQ(nearestTopic("/cmd_vell", topics), "did you mean '/cmd_vel'?");
  EXPECT_EQ(nearestTopic("/clock", {topics[0]}), "");
  EXPECT_EQ(nearestTopic("/something/else", topics), "");
}

}  // namespace
}  // namespace pongsim::cli
