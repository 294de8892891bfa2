#include "pongsim/messages/message_schema.hh"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor.pb.h>
#include <google/protobuf/message.h>
#include <gtest/gtest.h>

#include "pongsim/message.hh"

namespace pongsim {
namespace {

TEST(MessageSchema, DescribesATypeWithAllThatItIsMadeOf) {
  google::protobuf::FileDescriptorSet set;
  ASSERT_TRUE(set.ParseFromString(messageSchema("Twist")));
  // ordered so that each file follows its imports
  google::protobuf::DescriptorPool pool;
  for (const auto& file : set.file()) ASSERT_NE(pool.BuildFile(file), nullptr) << file.name();
  EXPECT_NE(pool.FindMessageTypeByName("ignition.msgs.Twist"), nullptr);
  EXPECT_NE(pool.FindMessageTypeByName("ignition.msgs.Vector3d"), nullptr);
}

TEST(MessageSchema, IsTheSameByDescriptorAndEmptyOfAnUnknownType) {
  const MessagePointer twist = newMessage("Twist");
  EXPECT_EQ(messageSchema(*twist->GetDescriptor()), messageSchema("ignition.msgs.Twist"));
  EXPECT_TRUE(messageSchema("some.Type").empty());
}

}  // namespace
}  // namespace pongsim
