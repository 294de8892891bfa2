#include "log/mcap/definition.hh"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor.pb.h>
#include <gtest/gtest.h>

namespace pongsim::log {
namespace {

TEST(Definition, DescribesATypeWithAllThatItIsMadeOf) {
  const Definition twist = protobufDefinition("ignition.msgs.Twist");
  EXPECT_EQ(twist.schemaEncoding, "protobuf");
  EXPECT_EQ(twist.messageEncoding, "protobuf");
  google::protobuf::FileDescriptorSet set;
  ASSERT_TRUE(set.ParseFromString(twist.schema));
  // ordered so that each file follows its imports
  google::protobuf::DescriptorPool pool;
  for (const auto& file : set.file()) ASSERT_NE(pool.BuildFile(file), nullptr) << file.name();
  EXPECT_NE(pool.FindMessageTypeByName("ignition.msgs.Twist"), nullptr);
  EXPECT_NE(pool.FindMessageTypeByName("ignition.msgs.Vector3d"), nullptr);
}

TEST(Definition, SaysLittleOfAnUnknownType) {
  EXPECT_EQ(protobufDefinition("some.Type"), (Definition{"", "", "protobuf"}));
}

}  // namespace
}  // namespace pongsim::log
