#include "msgs/encoding/bytes.hh"

#include <gtest/gtest.h>

#include <vector>

namespace pongsim::msgs {
namespace {

std::vector<std::byte> bytesOf(const Message& message) {
  std::vector<std::byte> bytes(byteSize(message));
  writeBytes(message, bytes);
  return bytes;
}

TEST(Bytes, LeadBackToTheMessage) {
  const MessagePointer twist = newMessage("Twist"), copy = newMessage("Twist");
  ASSERT_FALSE(parseMessage("linear {x: 0.5} angular {z: 0.05}", *twist).has_value());
  EXPECT_TRUE(parseBytes(bytesOf(*twist), *copy));
  EXPECT_EQ(messageText(*copy), messageText(*twist));
}

TEST(Bytes, AreRefusedWhereTheyEndTooEarly) {
  const MessagePointer twist = newMessage("Twist"), copy = newMessage("Twist");
  ASSERT_FALSE(parseMessage("linear {x: 0.5}", *twist).has_value());
  std::vector<std::byte> bytes = bytesOf(*twist);
  bytes.pop_back();
  EXPECT_FALSE(parseBytes(bytes, *copy));
}

TEST(Bytes, KnowTheTypesName) { EXPECT_EQ(typeName(*newMessage("Twist")), "ignition.msgs.Twist"); }

}  // namespace
}  // namespace pongsim::msgs
