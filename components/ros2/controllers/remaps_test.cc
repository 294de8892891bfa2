#include "ros2/controllers/remaps.hh"

#include <gtest/gtest.h>

#include "support/test_domain.hh"

namespace pongsim::ros2 {
namespace {

TEST(Remaps, GiveTopicsOtherNames) {
  Participant participant({.domain = test::testDomain()});
  const RosNode node(participant, {.name = "drive", .nameSpace = "/robot"});
  Remaps remaps;
  EXPECT_EQ(remaps.apply(node, "~/odom"), "/robot/drive/odom");
  EXPECT_TRUE(remaps.add("~/odom:=/odom"));
  EXPECT_TRUE(remaps.add("/robot/drive/cmd_vel:=cmd_vel"));
  EXPECT_TRUE(remaps.add("other:~/state:=/other"));
  EXPECT_TRUE(remaps.add("__ns:=/elsewhere"));
  EXPECT_FALSE(remaps.add("odom"));
  EXPECT_FALSE(remaps.add(":=odom"));
  const std::vector<std::string> arguments = {"--ros-args", "-r", "~/state:=/state", "-p", "a:=1"};
  remaps.addArguments(arguments);
  EXPECT_EQ(remaps.apply(node, "~/odom"), "/odom");
  EXPECT_EQ(remaps.apply(node, "~/cmd_vel"), "/robot/cmd_vel");
  EXPECT_EQ(remaps.apply(node, "~/state"), "/state");
  EXPECT_EQ(remaps.apply(node, "/tf"), "/tf");
}

}  // namespace
}  // namespace pongsim::ros2
