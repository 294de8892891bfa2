#include "log/command/decoder.hh"

#include <google/protobuf/descriptor.pb.h>
#include <gtest/gtest.h>
#include <ignition/msgs/twist.pb.h>

#include "log/store/failure.hh"

namespace pongsim::log {
namespace {

constexpr const char* kKnownType = "ignition.msgs.Twist";

std::string decoderRefusal(const Definition& definition, const std::string& type) {
  try {
    makeDecoder(definition, type);
  } catch (const Failure& failure) {
    return std::string(failure.what()) + " (" + failure.hint() + ")";
  }
  return "it is taken";
}

std::string someTwist() {
  ignition::msgs::Twist twist;
  twist.mutable_linear()->set_x(0.5);
  return twist.SerializeAsString();
}

TEST(Decoder, ReadsTypesThatAreKnownHereAndThoseThatTheFileDescribes) {
  for (const Definition& definition : {Definition{"", "", "protobuf"}, protobufDefinition(kKnownType)}) {
    const auto decoder = makeDecoder(definition, kKnownType);
    EXPECT_EQ(decoder->jsonOf(decoder->decode(someTwist())), R"({"linear":{"x":0.5}})");
    EXPECT_EQ(decoder->prototype().GetTypeName(), kKnownType);
  }
}

TEST(Decoder, ReadsATypeThatOnlyTheFileKnows) {
  google::protobuf::FileDescriptorSet set;
  auto* file = set.add_file();
  file->set_name("stranger.proto");
  file->set_syntax("proto3");
  file->set_package("stranger");
  auto* type = file->add_message_type();
  type->set_name("Count");
  auto* field = type->add_field();
  field->set_name("value");
  field->set_number(1);
  field->set_type(google::protobuf::FieldDescriptorProto::TYPE_INT32);
  field->set_label(google::protobuf::FieldDescriptorProto::LABEL_OPTIONAL);
  const auto decoder = makeDecoder({"protobuf", set.SerializeAsString(), "protobuf"}, "stranger.Count");
  EXPECT_EQ(decoder->jsonOf(decoder->decode("\x08\x07")), R"({"value":7})");
  EXPECT_NE(decoderRefusal({"protobuf", set.SerializeAsString(), "protobuf"}, "stranger.Other").find("lacks that type"),
            std::string::npos);
}

TEST(Decoder, RefusesWhatItCannotRead) {
  EXPECT_EQ(
      decoderRefusal({"ros2msg", "float64 x", "cdr"}, "a/msg/B"),
      "messages of 'a/msg/B' can't be read: their encoding is 'cdr', not protobuf (read it with the tools of ROS 2)");
  EXPECT_NE(decoderRefusal({"", "", "protobuf"}, "some.Type").find("is unknown"), std::string::npos);
  EXPECT_NE(decoderRefusal({"protobuf", "no description", "protobuf"}, kKnownType).find("is damaged"),
            std::string::npos);
  const auto decoder = makeDecoder(protobufDefinition(kKnownType), kKnownType);
  try {
    decoder->decode("\xff\xff\xff");
    FAIL();
  } catch (const Failure& failure) {
    EXPECT_STREQ(failure.what(), "its 3 bytes are not of type ignition.msgs.Twist");
  }
}

}  // namespace
}  // namespace pongsim::log
