#include "web/gz/frame.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/stringmsg.pb.h>

namespace pongsim::web::gz {
namespace {

TEST(GzFrame, IsReadByItsFirstThreeCommas) {
  const auto call = readCall("req,/s,ignition.msgs.StringMsg,a,b,,");
  ASSERT_TRUE(call.has_value());
  EXPECT_EQ(call->operation, "req");
  EXPECT_EQ(call->topic, "/s");
  EXPECT_EQ(call->type, "ignition.msgs.StringMsg");
  EXPECT_EQ(call->payload, "a,b,,");
  EXPECT_TRUE(readCall(",,,").has_value());
}

TEST(GzFrame, IsNoneWithFewerCommas) {
  for (const char* text : {"", "sub", "sub,,", "\xff\x00"}) EXPECT_FALSE(readCall(text).has_value()) << text;
}

TEST(GzFrame, HasAMessageBehindItsHead) {
  const web::Frame frame = textFrame("pub", "/t", "x");
  EXPECT_EQ(frame.head, "pub,/t,ignition.msgs.StringMsg,");
  ignition::msgs::StringMsg message;
  ASSERT_TRUE(message.ParseFromArray(frame.body.bytes().data(), static_cast<int>(frame.body.size())));
  EXPECT_EQ(message.data(), "x");
}

}  // namespace
}  // namespace pongsim::web::gz
