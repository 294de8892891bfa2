#include "ros2/recording/ros2_encoder.hh"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>
#include <gtest/gtest.h>
#include <ignition/msgs/laserscan.pb.h>
#include <ignition/msgs/pose_v.pb.h>
#include <ignition/msgs/twist.pb.h>

#include <cmath>

#include "ros2/pairs/pairs.hh"
#include "ros2/types/cdr.hh"
#include "ros2/types/geometry_msgs.hh"
#include "ros2/types/sensor_msgs.hh"
#include "ros2/types/tf2_msgs.hh"
#include "ros2/types/type_hash.hh"
#include "support/temp_folder.hh"

namespace pongsim::ros2 {
namespace {

constexpr const char* kScan = "ignition.msgs.LaserScan";
constexpr const char* kPoses = "ignition.msgs.Pose_V";

/// A payload and the index of its topic.
using Payload = std::pair<std::size_t, std::vector<std::byte>>;

std::vector<Payload> encoded(TopicEncoder& encoder, const std::string& bytes) {
  std::vector<Payload> payloads;
  encoder.encode(std::as_bytes(std::span(bytes)), [&payloads](std::size_t topic, std::span<const std::byte> payload) {
    payloads.emplace_back(topic, std::vector<std::byte>(payload.begin(), payload.end()));
  });
  return payloads;
}

template <class Ros>
Ros read(const Payload& payload) {
  Ros message;
  EXPECT_EQ(readCdr(payload.second, message), std::nullopt);
  return message;
}

class Ros2EncoderTest : public testing::Test {
 protected:
  /// A topic of a ros_gz_bridge configuration.
  std::unique_ptr<MessageEncoder> configured(const std::string& yaml) {
    return Ros2Encoder::make({{"config_file", folder_.write("bridge.yaml", yaml).string()}}, diagnostics_);
  }
  static std::unique_ptr<TopicEncoder> opened(MessageEncoder& encoder, const char* topic, const char* type) {
    auto open = encoder.openTopic(topic, type);
    const auto* why = std::get_if<std::string>(&open);
    EXPECT_EQ(why, nullptr) << *why;
    return why == nullptr ? std::get<std::unique_ptr<TopicEncoder>>(std::move(open)) : nullptr;
  }
  static std::string refusal(MessageEncoder& encoder, const char* topic, const char* type) {
    const auto open = encoder.openTopic(topic, type);
    return std::holds_alternative<std::string>(open) ? std::get<std::string>(open) : "it is taken";
  }

  test::TempFolder folder_;
  Diagnostics diagnostics_;
  Ros2Encoder plain_{{}};
};

TEST_F(Ros2EncoderTest, TurnsATopicIntoThatOfItsDefaultPair) {
  const auto lidar = opened(plain_, "/lidar-2d", kScan);
  ASSERT_EQ(lidar->topics().size(), 1U);
  const EncodedTopic& topic = lidar->topics()[0];
  EXPECT_EQ(topic.name, "/lidar_2d");
  EXPECT_EQ(topic.type, "sensor_msgs/msg/LaserScan");
  EXPECT_EQ(topic.messageEncoding, "cdr");
  EXPECT_EQ(topic.schemaEncoding, "ros2msg");
  EXPECT_EQ(topic.schema, messageDefinition<sensor_msgs::LaserScan>());
  EXPECT_EQ(topic.metadata.at("topic_type_hash"), typeHash<sensor_msgs::LaserScan>());
  EXPECT_NE(topic.metadata.at("offered_qos_profiles").find("durability: 2"), std::string::npos);

  ignition::msgs::LaserScan scan;
  scan.mutable_header()->mutable_stamp()->set_sec(7);
  scan.set_frame("robot::body::lidar");
  scan.set_count(2);
  scan.add_ranges(1.5);
  scan.add_ranges(2.5);
  const std::vector<Payload> payloads = encoded(*lidar, scan.SerializeAsString());
  ASSERT_EQ(payloads.size(), 1U);
  const auto ros = read<sensor_msgs::LaserScan>(payloads[0]);
  EXPECT_EQ(ros.header.stamp.sec, 7);
  EXPECT_EQ(ros.header.frame_id, "robot/body/lidar");
  EXPECT_EQ(ros.ranges, (std::vector<float>{1.5F, 2.5F}));
}

TEST_F(Ros2EncoderTest, SaysWhyATopicIsLeftOut) {
  EXPECT_EQ(refusal(plain_, "/scene", "ignition.msgs.Scene"), "ignition.msgs.Scene has no counterpart in ROS");
  EXPECT_EQ(refusal(plain_, "/x", "other.Type"), "other.Type has no counterpart in ROS");
  opened(plain_, "/a-b", kScan);
  EXPECT_EQ(refusal(plain_, "/a_b", "ignition.msgs.Twist"),
            "ROS topic '/a_b' already has type sensor_msgs/msg/LaserScan, from '/a-b'");
}

TEST_F(Ros2EncoderTest, RefusesBytesThatAreNoMessage) {
  const auto lidar = opened(plain_, "/lidar", kScan);
  try {
    encoded(*lidar, "\xff\xff\xff");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "3 bytes are not of type ignition.msgs.LaserScan");
  }
  EXPECT_EQ(encoded(*lidar, "").size(), 1U);
}

/// Sets each field, also in nested messages, to its largest or smallest number.
void fillWithExtremes(Message& message, bool isLargest, int depth = 0) {
  using google::protobuf::FieldDescriptor;
  const auto* reflection = message.GetReflection();
  const auto fill = [&](const FieldDescriptor& field, const auto& extremes, const auto& set, const auto& add) {
    const auto value = isLargest ? extremes.second : extremes.first;
    if (field.is_repeated()) {
      (reflection->*add)(&message, &field, value);
    } else {
      (reflection->*set)(&message, &field, value);
    }
  };
  using R = google::protobuf::Reflection;
  for (int i = 0; i < message.GetDescriptor()->field_count(); ++i) {
    const FieldDescriptor& field = *message.GetDescriptor()->field(i);
    switch (field.cpp_type()) {
      case FieldDescriptor::CPPTYPE_INT32:
        fill(field, std::pair(INT32_MIN, INT32_MAX), &R::SetInt32, &R::AddInt32);
        break;
      case FieldDescriptor::CPPTYPE_INT64:
        fill(field, std::pair(INT64_MIN, INT64_MAX), &R::SetInt64, &R::AddInt64);
        break;
      case FieldDescriptor::CPPTYPE_UINT32:
        // if sizes are multiplied, the product must be large
        fill(field, std::pair(0x10001U, UINT32_MAX), &R::SetUInt32, &R::AddUInt32);
        break;
      case FieldDescriptor::CPPTYPE_UINT64:
        fill(field, std::pair(std::uint64_t{0}, UINT64_MAX), &R::SetUInt64, &R::AddUInt64);
        break;
      case FieldDescriptor::CPPTYPE_ENUM:
        fill(field, std::pair(INT32_MIN, INT32_MAX), &R::SetEnumValue, &R::AddEnumValue);
        break;
      case FieldDescriptor::CPPTYPE_MESSAGE:
        if (depth == 4 || field.is_map()) break;
        fillWithExtremes(field.is_repeated() ? *reflection->AddMessage(&message, &field)
                                             : *reflection->MutableMessage(&message, &field),
                         isLargest, depth + 1);
        break;
      default:
        break;
    }
  }
}

// a message from another process or a file may contain anything
TEST_F(Ros2EncoderTest, TakesNumbersOfAnySize) {
  for (const Pair& pair : allPairs()) {
    if (!pair.isDefault) continue;
    const auto encoder =
        opened(plain_, ("/" + pair.ignition.substr(pair.ignition.rfind('.') + 1)).c_str(), pair.ignition.c_str());
    for (const bool isLargest : {true, false}) {
      const MessagePointer message = newMessage(pair.ignition);
      fillWithExtremes(*message, isLargest);
      EXPECT_EQ(encoded(*encoder, message->SerializeAsString()).size(), 1U) << pair.ignition;
    }
  }
}

TEST_F(Ros2EncoderTest, HasTheOdometryOfRobotsAmongTheTransforms) {
  const auto odometry = opened(plain_, "/model/robot/tf", kPoses);
  ASSERT_EQ(odometry->topics().size(), 2U);
  EXPECT_EQ(odometry->topics()[0].name, "/model/robot/tf");
  EXPECT_EQ(odometry->topics()[1].name, "/tf");
  EXPECT_EQ(opened(plain_, "/model/other/tf", kPoses)->topics().size(), 2U);
  EXPECT_EQ(opened(plain_, "/world/w/pose/info", kPoses)->topics().size(), 1U);

  ignition::msgs::Pose_V poses;
  auto* entry = poses.add_pose()->mutable_header()->add_data();
  entry->set_key("frame_id");
  entry->add_value("robot/odom");
  const std::vector<Payload> payloads = encoded(*odometry, poses.SerializeAsString());
  ASSERT_EQ(payloads.size(), 2U);
  EXPECT_EQ(payloads[0].second, payloads[1].second);
  EXPECT_EQ(payloads[1].first, 1U);
  EXPECT_EQ(read<tf2_msgs::TFMessage>(payloads[1]).transforms[0].header.frame_id, "robot/odom");
}

TEST_F(Ros2EncoderTest, FollowsAConfiguration) {
  const auto encoder = configured(R"(
- {ros_topic_name: /scan, gz_topic_name: /lidar, ros_type_name: sensor_msgs/msg/LaserScan,
   gz_type_name: ignition.msgs.LaserScan, direction: GZ_TO_ROS, qos_profile: SENSOR_DATA, frame_id: laser}
- {ros_topic_name: /cmd, gz_topic_name: /cmd_vel, ros_type_name: geometry_msgs/msg/TwistStamped,
   gz_type_name: ignition.msgs.Twist, direction: ROS_TO_GZ}
- {ros_topic_name: /tf, gz_topic_name: /model/a/tf, ros_type_name: tf2_msgs/msg/TFMessage,
   gz_type_name: ignition.msgs.Pose_V, frame_prefix: x/}
- {ros_topic_name: /tf_static, gz_topic_name: /fixed, ros_type_name: tf2_msgs/msg/TFMessage,
   gz_type_name: ignition.msgs.Pose_V}
)");
  ASSERT_NE(encoder, nullptr);
  const auto lidar = opened(*encoder, "/lidar", kScan);
  ASSERT_EQ(lidar->topics().size(), 1U);
  EXPECT_EQ(lidar->topics()[0].name, "/scan");
  EXPECT_NE(lidar->topics()[0].metadata.at("offered_qos_profiles").find("reliability: 2"), std::string::npos);
  EXPECT_EQ(read<sensor_msgs::LaserScan>(encoded(*lidar, "")[0]).header.frame_id, "laser");
  EXPECT_EQ(opened(*encoder, "/cmd_vel", "ignition.msgs.Twist")->topics()[0].type, "geometry_msgs/msg/TwistStamped");
  EXPECT_EQ(refusal(*encoder, "/scan", kScan), "the configuration gives its ROS name, '/scan', to '/lidar'");
  // a topic with a rule has only that name; the transforms of others are unaffected
  EXPECT_EQ(opened(*encoder, "/model/a/tf", kPoses)->topics().size(), 1U);
  EXPECT_EQ(opened(*encoder, "/model/b/tf", kPoses)->topics().size(), 2U);
  const auto fixed = opened(*encoder, "/fixed", kPoses);
  EXPECT_NE(fixed->topics()[0].metadata.at("offered_qos_profiles").find("durability: 1"), std::string::npos);
}

TEST_F(Ros2EncoderTest, ReadsWhatComesFromRos) {
  auto opened = plain_.openInput("geometry_msgs/msg/Twist", "");
  ASSERT_TRUE(std::holds_alternative<std::unique_ptr<TopicDecoder>>(opened)) << std::get<std::string>(opened);
  TopicDecoder& decoder = *std::get<std::unique_ptr<TopicDecoder>>(opened);
  EXPECT_EQ(decoder.encoding().type, "geometry_msgs/msg/Twist");
  EXPECT_EQ(decoder.messageType(), "ignition.msgs.Twist");
  EXPECT_EQ(decoder.encoding().schema, messageDefinition<geometry_msgs::Twist>());
  geometry_msgs::Twist ros;
  ros.linear.x = 0.5;
  std::vector<std::byte> payload(cdrSize(ros));
  writeCdr(ros, payload);
  const Message& message = decoder.decode(payload);
  ASSERT_EQ(message.GetTypeName(), "ignition.msgs.Twist");
  EXPECT_EQ(static_cast<const ignition::msgs::Twist&>(message).linear().x(), 0.5);
  EXPECT_THROW(decoder.decode(std::span(payload).first(7)), std::runtime_error);
  ros.linear.x = NAN;
  writeCdr(ros, payload);
  EXPECT_THROW(decoder.decode(payload), std::runtime_error) << "it is a command";
}

TEST_F(Ros2EncoderTest, SaysWhichTypesItCanNotRead) {
  const auto refusalOf = [&](const char* ros, const char* type) {
    const auto opened = plain_.openInput(ros, type);
    return std::holds_alternative<std::string>(opened) ? std::get<std::string>(opened) : "";
  };
  EXPECT_EQ(refusalOf("geometry_msgs/msg/Twits", "").find("'geometry_msgs/msg/Twits' is no type of ROS"), 0U);
  EXPECT_EQ(refusalOf("geometry_msgs/msg/Twist", kScan),
            "geometry_msgs/msg/Twist can't be converted to ignition.msgs.LaserScan");
  EXPECT_EQ(refusalOf("geometry_msgs/msg/TwistStamped", "ignition.msgs.Twist"), "");
}

TEST_F(Ros2EncoderTest, SaysWhatIsWrongWithItsSettings) {
  EXPECT_EQ(configured("- {topic_name: /a, ros_type_name: std_msgs/msg/Strin, gz_type_name: ignition.msgs.StringMsg}"),
            nullptr);
  ASSERT_TRUE(diagnostics_.hasErrors());
  EXPECT_EQ(diagnostics_.all()[0].position.line, 1);
  EXPECT_EQ(diagnostics_.all()[0].hint, "did you mean 'std_msgs/msg/String'?");
  Diagnostics other;
  EXPECT_EQ(Ros2Encoder::make({{"config", "x"}}, other), nullptr);
  EXPECT_EQ(other.all().at(0).message, "the ROS 2 encoding has no setting 'config'");
}

}  // namespace
}  // namespace pongsim::ros2
