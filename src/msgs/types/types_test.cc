#include <google/protobuf/message.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "pongsim/message.hh"

namespace pongsim {
namespace {

TEST(MessageTypes, HaveAllTheNamesThatFortressAndItsSuccessorsUse) {
  for (const char* name : {"ignition.msgs.Twist", ".ignition.msgs.Twist", "ign_msgs.Twist", "gz.msgs.Twist", "Twist"}) {
    EXPECT_EQ(messageTypeName(name), "ignition.msgs.Twist") << name;
    const MessagePointer message = newMessage(name);
    ASSERT_NE(message, nullptr) << name;
    EXPECT_EQ(message->GetTypeName(), "ignition.msgs.Twist");
  }
}

TEST(MessageTypes, AreNotWhatIsNoMessage) {
  for (const char* name : {"", ".", "Nothing", "ignition.msgs.", "ignition.msgs.Nothing", "google.protobuf.Any",
                           "ignition.msgs.Entity.Type", "ignition.msgs.Twist.linear", "twist", "Twist ", "a b\n"}) {
    EXPECT_EQ(messageTypeName(name), std::nullopt) << name;
    EXPECT_EQ(newMessage(name), nullptr) << name;
  }
  EXPECT_EQ(messageTypeName(std::string(1'000'000, 'x')), std::nullopt);
}

TEST(MessageTypes, LeaveOutTheEntriesOfMaps) {
  EXPECT_EQ(messageTypeName("ignition.msgs.SerializedEntityMap.ComponentsEntry"), std::nullopt);
  EXPECT_EQ(messageTypeName("ignition.msgs.CameraInfo.Distortion"), "ignition.msgs.CameraInfo.Distortion");
}

TEST(MessageTypes, AreListedSortedAndEachCanBeMade) {
  const std::vector<std::string> types = messageTypes();
  EXPECT_GT(types.size(), 150U);
  EXPECT_TRUE(std::is_sorted(types.begin(), types.end()));
  EXPECT_TRUE(std::binary_search(types.begin(), types.end(), "ignition.msgs.Odometry"));
  for (const std::string& type : types) EXPECT_NE(newMessage(type), nullptr) << type;
}

TEST(MessageTypes, AreFoundByANearSpelling) {
  EXPECT_EQ(nearestMessageType("ignition.msgs.Twisst"), "ignition.msgs.Twist");
  EXPECT_EQ(nearestMessageType("gz.msgs.odometry"), "ignition.msgs.Odometry");
  EXPECT_EQ(nearestMessageType("Vector3D"), "ignition.msgs.Vector3d");
  EXPECT_EQ(nearestMessageType("qqqqqqqqqqqq"), "");
}

TEST(MessageTypes, ThatDebianLacksIsThereByAllNames) {
  for (const char* type :
       {"Dataframe", "EntityWrench", "OdometryWithCovariance", "PoseWithCovariance", "TwistWithCovariance"}) {
    const std::string name = std::string("ignition.msgs.") + type;
    EXPECT_EQ(messageTypeName(type), name);
    EXPECT_EQ(messageTypeName(std::string("gz.msgs.") + type), name);
    const MessagePointer message = newMessage(type);
    ASSERT_TRUE(message) << type;
  }
}

// as ignition-msgs 8.7 has them
TEST(MessageTypes, ThatDebianLacksHasTheNumbersOfItsFields) {
  const MessagePointer message = newMessage("OdometryWithCovariance");
  ASSERT_FALSE(parseMessage(
      "header {stamp {sec: 1}} pose_with_covariance {pose {id: 2} covariance {data: 3}} twist_with_covariance {}",
      *message));
  const std::string expected(
      "\x0a\x04\x0a\x02\x08\x01"                              // 1: header
      "\x12\x0c\x0a\x02\x18\x02\x12\x06\x12\x04\0\0\x40\x40"  // 2: pose with covariance
      "\x1a\0",                                               // 3: twist with covariance
      22);
  EXPECT_EQ(message->SerializeAsString(), expected);
}

// as gz-msgs 11 has them
TEST(MessageTypes, OfLaterReleasesHaveTheNumbersOfTheirFields) {
  const auto bytesOf = [](const char* type, const char* text) {
    const MessagePointer message = newMessage(type);
    EXPECT_FALSE(parseMessage(text, *message)) << type;
    return message->SerializeAsString();
  };
  EXPECT_EQ(bytesOf("gz.msgs.AirSpeed", "header {} diff_pressure: 2 temperature: 2"),
            std::string("\x0a\0\x11\0\0\0\0\0\0\0\x40\x19\0\0\0\0\0\0\0\x40", 20));
  EXPECT_EQ(bytesOf("DVLVelocityTracking",
                    "header {} type: DVL_TYPE_PHASED_ARRAY target {type: DVL_TARGET_WATER_MASS range {} position {}} "
                    "velocity {reference: DVL_REFERENCE_SHIP mean {}} beams {id: 1 velocity {} range {} locked: true} "
                    "status: 1"),
            std::string("\x0a\0\x10\x02\x1a\x06\x08\x02\x12\0\x1a\0\x22\x04\x08\x02\x12\0"
                        "\x2a\x08\x08\x01\x12\0\x1a\0\x30\x01\x30\x01",
                        30));
}

}  // namespace
}  // namespace pongsim
