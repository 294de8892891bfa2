#include "cli/topic/field_condition.hh"

#include <google/protobuf/message.h>
#include <gtest/gtest.h>

#include "shared/program/failure.hh"

namespace pongsim::cli {
namespace {

constexpr const char* kOdometry = "ignition.msgs.Odometry";

bool isMet(const char* condition, const char* text) {
  const MessagePointer message = newMessage(kOdometry);
  EXPECT_FALSE(parseMessage(text, *message));
  MessageError error;
  const auto check = FieldCheck::make(FieldCondition::parse(condition), kOdometry, error);
  EXPECT_TRUE(check) << error.message;
  return check && check->isMetBy(*message);
}

std::string errorOf(const char* condition) {
  MessageError error;
  EXPECT_FALSE(FieldCheck::make(FieldCondition::parse(condition), kOdometry, error)) << condition;
  return error.message;
}

TEST(FieldCondition, ComparesNumbers) {
  const char* const text = "pose {position {x: 1.5}}";
  for (const char* yes :
       {"pose.position.x == 1.5", "pose.position.x=1.5", "pose.position.x >= 1.5", "pose.position.x <= 1.5",
        "pose.position.x > -2", "pose.position.x<2e0", "pose.position.x != 1", "  pose.position.y == 0 "}) {
    EXPECT_TRUE(isMet(yes, text)) << yes;
  }
  for (const char* no : {"pose.position.x == 1.4", "pose.position.x > 1.5", "pose.position.x < 1.5",
                         "pose.position.x >= 1.6", "pose.position.x <= 1", "pose.position.x != 1.5"}) {
    EXPECT_FALSE(isMet(no, text)) << no;
  }
}

TEST(FieldCondition, ComparesTexts) {
  EXPECT_TRUE(isMet("pose.name == a b", "pose {name: 'a b'}"));
  EXPECT_TRUE(isMet("pose.name != a", "pose {name: 'b'}"));
  EXPECT_FALSE(isMet("pose.name == a", "pose {name: 'b'}"));
  EXPECT_TRUE(isMet("header.data[0].key == k", "header {data {key: 'k'}}"));
  EXPECT_FALSE(isMet("header.data[1].key == k", "header {data {key: 'k'}}"));
  EXPECT_FALSE(isMet("header.data[1].key != k", "header {data {key: 'k'}}"));
}

TEST(FieldCondition, RefusesWhatIsNone) {
  for (const char* text : {"", "pose.position.x", "== 1", "pose.position.x ==", "pose.position.x > ", "=", "!"}) {
    EXPECT_THROW(FieldCondition::parse(text), UsageError) << text;
  }
}

TEST(FieldCondition, FitsTheMessage) {
  EXPECT_EQ(errorOf("pose.position.w > 1"), "field 'w' is not in ignition.msgs.Vector3d");
  EXPECT_EQ(errorOf("pose.position.x > far"),
            "'pose.position.x' of ignition.msgs.Odometry is a number, but 'far' is not");
  EXPECT_EQ(errorOf("pose.name > a"), "'pose.name' of ignition.msgs.Odometry is not a number");
}

}  // namespace
}  // namespace pongsim::cli
