#include "ros2/config/topic_argument.hh"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace pongsim::ros2 {
namespace {

const SourcePosition kPlace{std::make_shared<const std::string>("world.sdf"), 3, 5};

std::optional<RuleText> argumentOf(std::string_view text) {
  Diagnostics diagnostics;
  auto rule = readTopicArgument(text, kPlace, diagnostics);
  EXPECT_EQ(rule.has_value(), diagnostics.all().empty()) << text;
  return rule;
}

std::string errorOf(std::string_view text) {
  Diagnostics diagnostics;
  EXPECT_FALSE(readTopicArgument(text, kPlace, diagnostics).has_value()) << text;
  return diagnostics.all().size() == 1 ? diagnostics.all()[0].message : "";
}

TEST(TopicArgument, SaysTheTypesAndTheDirection) {
  const auto both = argumentOf("/chatter@std_msgs/msg/String@ignition.msgs.StringMsg");
  ASSERT_TRUE(both.has_value());
  EXPECT_FALSE(both->isService);
  EXPECT_EQ(both->ros->text, "/chatter");
  EXPECT_EQ(both->ignition->text, "/chatter");
  EXPECT_EQ(both->rosType->text, "std_msgs/msg/String");
  EXPECT_EQ(both->ignitionType->text, "ignition.msgs.StringMsg");
  EXPECT_EQ(both->direction, Direction::kBoth);
  EXPECT_EQ(both->position, kPlace);
  EXPECT_EQ(argumentOf("/scan@sensor_msgs/msg/LaserScan[gz.msgs.LaserScan")->direction, Direction::kToRos);
  EXPECT_EQ(argumentOf("/cmd_vel@geometry_msgs/msg/Twist]gz.msgs.Twist")->direction, Direction::kFromRos);
}

TEST(TopicArgument, IsAServiceByItsType) {
  const auto plain = argumentOf("/world/w/control@ros_gz_interfaces/srv/ControlWorld");
  ASSERT_TRUE(plain.has_value());
  EXPECT_TRUE(plain->isService);
  EXPECT_FALSE(plain->requestType.has_value());
  const auto typed =
      argumentOf("/world/w/control@ros_gz_interfaces/srv/ControlWorld@gz.msgs.WorldControl@gz.msgs.Boolean");
  EXPECT_EQ(typed->requestType->text, "gz.msgs.WorldControl");
  EXPECT_EQ(typed->replyType->text, "gz.msgs.Boolean");
}

TEST(TopicArgument, SaysWhatIsWrong) {
  EXPECT_EQ(errorOf(""), "'' has no topic before the '@'");
  EXPECT_EQ(errorOf("@a@b"), "'@a@b' has no topic before the '@'");
  EXPECT_EQ(errorOf("/a@@b"), "'/a@@b' has no ROS type");
  EXPECT_EQ(errorOf("/a@std_msgs/msg/String"), "'/a@std_msgs/msg/String' has no simulation type");
  EXPECT_EQ(errorOf("/a@std_msgs/msg/String["), "'/a@std_msgs/msg/String[' has no simulation type");
  EXPECT_EQ(errorOf("/a@b@c@d"), "'/a@b@c@d' has more than two types");
  EXPECT_EQ(errorOf("/a@b@c]d"), "'/a@b@c]d' has more than two types");
  EXPECT_EQ(errorOf("/a@p/srv/S[c"), "'/a@p/srv/S[c' is a service, which has no direction");
  EXPECT_NE(errorOf("/a@p/srv/S@c").find("both types or neither"), std::string::npos);
}

}  // namespace
}  // namespace pongsim::ros2
