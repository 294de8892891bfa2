#include "pongsim/messages/field_path.hh"

#include <google/protobuf/message.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pongsim::msgs {
namespace {

MessagePointer messageOf(const char* type, const char* text) {
  MessagePointer message = newMessage(type);
  const std::optional<MessageError> error = parseMessage(text, *message);
  EXPECT_FALSE(error) << error->message;
  return message;
}

FieldPath pathOf(const char* type, const char* path) {
  MessageError error;
  const std::optional<FieldPath> result = FieldPath::parse(std::string("ignition.msgs.") + type, path, error);
  if (!result) throw std::runtime_error(error.message);
  return *result;
}

MessageError errorOf(const char* type, const char* path) {
  MessageError error;
  EXPECT_FALSE(FieldPath::parse(std::string("ignition.msgs.") + type, path, error)) << path;
  return error;
}

TEST(FieldPath, LeadsToValues) {
  const auto odometry = messageOf("Odometry", "pose {position {x: 0.1 y: -2}}, header {stamp {sec: 3 nsec: 5}}");
  const auto value = [&](const char* path) { return pathOf("Odometry", path).valueIn(*odometry); };
  EXPECT_EQ(value("pose.position.x"), "0.1");
  EXPECT_EQ(value("pose.position.z"), "0");
  EXPECT_EQ(value("header.stamp"), "{sec: 3 nsec: 5}");
  EXPECT_EQ(value("pose.name"), "");
  EXPECT_EQ(pathOf("Odometry", "pose.position.y").numberIn(*odometry), -2);
  EXPECT_EQ(pathOf("Odometry", "header.stamp.sec").numberIn(*odometry), 3);
  EXPECT_EQ(pathOf("Odometry", "pose.position.y").text(), "pose.position.y");
}

TEST(FieldPath, LeadsIntoLists) {
  const auto poses = messageOf("Pose_V", "pose {name: 'a b' position {x: 1}}, pose {name: 'c'}");
  const auto value = [&](const char* path) { return pathOf("Pose_V", path).valueIn(*poses); };
  EXPECT_EQ(value("pose[0].name"), "a b");
  EXPECT_EQ(value("pose[1].name"), "c");
  EXPECT_EQ(value("pose[1]"), "{name: \"c\"}");
  EXPECT_EQ(value("pose[2]"), std::nullopt);
  EXPECT_EQ(value("pose[2].position.x"), std::nullopt);
  EXPECT_EQ(pathOf("Pose_V", "pose[2].position.x").numberIn(*poses), std::nullopt);
  const auto numbers = messageOf("Double_V", "data: [1, 2.5]");
  EXPECT_EQ(pathOf("Double_V", "data").valueIn(*numbers), "[1, 2.5]");
  EXPECT_EQ(pathOf("Double_V", "data[1]").numberIn(*numbers), 2.5);
}

TEST(FieldPath, LeadsToListsOfNumbers) {
  const auto doubles = messageOf("Double_V", "data: [1, 2.5, inf]");
  EXPECT_TRUE(pathOf("Double_V", "data").isNumberList());
  EXPECT_EQ(pathOf("Double_V", "data").numbersIn(*doubles),
            (std::vector<double>{1, 2.5, std::numeric_limits<double>::infinity()}));
  const auto floats = messageOf("Float_V", "data: [0.1, -3]");
  EXPECT_EQ(pathOf("Float_V", "data").numbersIn(*floats), (std::vector<double>{0.1, -3}));
  EXPECT_FALSE(pathOf("Double_V", "data[0]").isNumberList());
  EXPECT_FALSE(pathOf("Pose_V", "pose").isNumberList());
  EXPECT_FALSE(pathOf("Twist", "linear.x").isNumberList());
}

TEST(FieldPath, KnowsNumbers) {
  EXPECT_TRUE(pathOf("Twist", "linear.x").isNumber());
  EXPECT_TRUE(pathOf("Boolean", "data").isNumber());
  EXPECT_TRUE(pathOf("Double_V", "data[0]").isNumber());
  EXPECT_FALSE(pathOf("Double_V", "data").isNumber());
  EXPECT_FALSE(pathOf("StringMsg", "data").isNumber());
  EXPECT_FALSE(pathOf("Twist", "linear").isNumber());
  EXPECT_FALSE(pathOf("Entity", "type").isNumber());
  const auto yes = messageOf("Boolean", "data: true");
  EXPECT_EQ(pathOf("Boolean", "data").numberIn(*yes), 1);
  EXPECT_EQ(pathOf("Boolean", "data").numberIn(*newMessage("Boolean")), 0);
  const auto endless = messageOf("Double", "data: -inf");
  EXPECT_EQ(pathOf("Double", "data").numberIn(*endless), -INFINITY);
}

TEST(FieldPath, SaysWhatIsWrongAndWhere) {
  const MessageError lineer = errorOf("Twist", "lineer.x");
  EXPECT_EQ(lineer.message, "field 'lineer' is not in ignition.msgs.Twist");
  EXPECT_EQ(lineer.hint, "did you mean 'linear'?");
  EXPECT_EQ(lineer.column, 1);
  EXPECT_EQ(errorOf("Twist", "linear.w").column, 8);
  EXPECT_EQ(errorOf("Twist", "linear.x.y").message, "there is no 'y' in ignition.msgs.Vector3d.x");
  EXPECT_EQ(errorOf("Pose_V", "pose.name").hint, "say which: pose[0]");
  EXPECT_EQ(errorOf("Pose_V", "pose[x].name").hint, "the first is [0]");
  EXPECT_EQ(errorOf("Twist", "linear[0].x").message, "field 'linear' is not a list");
  for (const char* path : {"", ".", "linear.", ".x", "linear..x", "pose[", "pose[-1]", "pose[]", "[0]", "linear]"}) {
    errorOf("Twist", path);
    errorOf("Pose_V", path);
  }
  EXPECT_EQ(errorOf("Nothing", "x").message, "unknown message type 'ignition.msgs.Nothing'");
}

TEST(ScalarPaths, AreThoseOfSingleValues) {
  const std::vector<std::string> twist = scalarPaths("ignition.msgs.Twist");
  EXPECT_EQ(std::count(twist.begin(), twist.end(), "linear.x"), 1);
  EXPECT_EQ(std::count(twist.begin(), twist.end(), "header.stamp.sec"), 1);
  for (const std::string& path : twist) {
    EXPECT_EQ(path.find("header.data"), std::string::npos) << path;
    EXPECT_EQ(path.find(".header"), std::string::npos) << path;
  }
  for (const std::string& type : messageTypes()) {
    MessageError error;
    for (const std::string& path : scalarPaths(type)) EXPECT_TRUE(FieldPath::parse(type, path, error)) << path;
  }
}

}  // namespace
}  // namespace pongsim::msgs
