#include "transport/names/topic_name.hh"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "pongsim/node.hh"

namespace pongsim {

TEST(TopicName, TakesWhatFortressTakes) {
  for (const char* name : {"/clock", "clock", "/world/w/model/m::n/link-1/sensor.x", "/a/b/", "/ünïcode"}) {
    EXPECT_EQ(topicNameError(name), std::nullopt) << name;
  }
}

TEST(TopicName, SaysWhatIsWrong) {
  EXPECT_EQ(topicNameError(""), "is empty");
  EXPECT_EQ(topicNameError("/"), "is only a slash");
  EXPECT_EQ(topicNameError("/cmd vel"), "has a space");
  EXPECT_EQ(topicNameError("~/cmd_vel"), "has '~'");
  EXPECT_EQ(topicNameError("/a//b"), "has '//'");
  EXPECT_EQ(topicNameError("@/a"), "has '@'");
  EXPECT_EQ(topicNameError("/a:=b"), "has ':='");
  EXPECT_EQ(topicNameError("/" + std::string(254, 'a')), std::nullopt);
  EXPECT_EQ(topicNameError(std::string(255, 'a')), "is longer than 255 characters");
}

TEST(TopicName, GetsALeadingSlashAndLosesATrailingOne) {
  EXPECT_EQ(transport::absoluteTopic("cmd_vel"), "/cmd_vel");
  EXPECT_EQ(transport::absoluteTopic("/cmd_vel"), "/cmd_vel");
  EXPECT_EQ(transport::absoluteTopic("a/b/"), "/a/b");
  EXPECT_THROW(transport::absoluteTopic("a b"), std::invalid_argument);
}

}  // namespace pongsim
