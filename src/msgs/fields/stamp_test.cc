#include "msgs/fields/stamp.hh"

#include <gtest/gtest.h>

#include <chrono>

namespace pongsim::msgs {
namespace {

MessagePointer stampedMessage(const char* type, const char* text) {
  MessagePointer message = newMessage(type);
  EXPECT_FALSE(parseMessage(text, *message)) << text;
  return message;
}

TEST(Stamp, IsInTheHeader) {
  EXPECT_TRUE(hasStamp("ignition.msgs.Odometry"));
  EXPECT_FALSE(hasStamp("ignition.msgs.Double_V")) << "has no header";
  EXPECT_FALSE(hasStamp("no.such.Type"));
  const auto stamped = stampedMessage("Odometry", "header {stamp {sec: 2, nsec: 500}}");
  EXPECT_EQ(stampOf(*stamped), std::chrono::seconds(2) + std::chrono::nanoseconds(500));
  EXPECT_EQ(stampOf(*stampedMessage("Odometry", "header {}")), std::nullopt);
  EXPECT_EQ(stampOf(*stampedMessage("Double_V", "data: 1")), std::nullopt);
}

TEST(Stamp, OfAClockIsOfBothTimes) {
  const ClockReading reading = clockReading(*stampedMessage("Clock", "system {sec: 100} sim {nsec: 7}"));
  EXPECT_EQ(reading.simulated, std::chrono::nanoseconds(7));
  EXPECT_EQ(reading.system, std::chrono::seconds(100));
}

}  // namespace
}  // namespace pongsim::msgs
