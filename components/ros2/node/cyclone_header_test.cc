#include "ros2/node/cyclone_header.hh"

#include <gtest/gtest.h>

#include <cstdint>

namespace pongsim::ros2 {
namespace {

std::vector<std::byte> bytesOf(const std::vector<int>& values) {
  std::vector<std::byte> bytes;
  for (const int value : values) bytes.push_back(std::byte(value));
  return bytes;
}

TEST(CycloneHeaderTest, StandsBetweenEncapsulationAndMessage) {
  const auto payload = bytesOf({0, 1, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 0, 0, 0, 0, 0, 0, 0, 42});
  const auto split = splitCyclonePayload(payload);
  ASSERT_TRUE(split);
  EXPECT_EQ(split->header, bytesOf({1, 2, 3, 4, 5, 6, 7, 8, 9, 0, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(split->message, bytesOf({0, 1, 0, 0, 42}));
  EXPECT_EQ(cyclonePayload(split->header, split->message), payload);
}

TEST(CycloneHeaderTest, OfBigEndianClientsIsTurned) {
  const auto split = splitCyclonePayload(bytesOf({0, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 0, 0, 0, 0, 0, 0, 0, 9, 42}));
  ASSERT_TRUE(split);
  EXPECT_EQ(split->header, bytesOf({8, 7, 6, 5, 4, 3, 2, 1, 9, 0, 0, 0, 0, 0, 0, 0}));
}

TEST(CycloneHeaderTest, IsMissingInAShortPayload) {
  EXPECT_FALSE(splitCyclonePayload({}));
  EXPECT_FALSE(splitCyclonePayload(std::vector<std::byte>(19)));
  EXPECT_TRUE(splitCyclonePayload(std::vector<std::byte>(20)));
}

}  // namespace
}  // namespace pongsim::ros2
