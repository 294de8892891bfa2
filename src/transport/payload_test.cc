#include "transport/payload.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace pongsim::transport {

namespace {

std::vector<std::byte> framed(std::size_t messageSize) {
  std::vector<std::byte> payload(payloadSize(messageSize), std::byte{0xff});
  std::ranges::fill(framePayload(payload, messageSize), std::byte{0x55});
  return payload;
}

}  // namespace

TEST(Payload, GivesBackTheMessageWhateverItsSize) {
  for (std::size_t size : {0, 1, 2, 3, 4, 5, 255, 256, 70'000}) {
    const std::vector<std::byte> payload = framed(size);
    EXPECT_EQ(payload.size() % 4, 0);
    const auto message = messageInPayload(payload);
    ASSERT_TRUE(message) << size;
    EXPECT_EQ(message->size(), size);
    EXPECT_EQ(std::ranges::count(*message, std::byte{0x55}), static_cast<std::ptrdiff_t>(size));
  }
}

TEST(Payload, ReadsBigEndianToo) {
  std::vector<std::byte> payload = framed(5);
  payload[1] = std::byte{0};
  std::reverse(payload.begin() + 4, payload.begin() + 8);
  ASSERT_TRUE(messageInPayload(payload));
  EXPECT_EQ(messageInPayload(payload)->size(), 5);
}

TEST(Payload, SaysWhetherItIsKept) {
  std::vector<std::byte> payload = framed(5);
  EXPECT_EQ(keepingOf(payload), Keeping::kNone);
  framePayload(payload, 5, Keeping::kKept);
  EXPECT_EQ(keepingOf(payload), Keeping::kKept);
  markAsAgain(payload);
  EXPECT_EQ(keepingOf(payload), Keeping::kAgain);
  // to whom that means nothing it is a message as any other
  EXPECT_TRUE(messageInPayload(payload));
  EXPECT_EQ(keepingOf({payload.data(), 3}), Keeping::kNone);
}

TEST(Payload, RefusesWhatIsTruncatedOrHasAWrongLength) {
  const std::vector<std::byte> good = framed(5);
  for (std::size_t size = 0; size < good.size(); ++size) EXPECT_FALSE(messageInPayload({good.data(), size})) << size;
  std::vector<std::byte> longer = good;
  longer.resize(good.size() + 4);
  EXPECT_FALSE(messageInPayload(longer));
  for (std::size_t i : {4, 5, 6, 7}) {
    std::vector<std::byte> wrongLength = good;
    wrongLength[i] = std::byte{0xff};
    EXPECT_FALSE(messageInPayload(wrongLength)) << i;
  }
}

TEST(Payload, RefusesAnotherEncapsulation) {
  for (auto [place, value] : {std::pair{0, 1}, std::pair{1, 2}, std::pair{1, 3}, std::pair{1, 255}}) {
    std::vector<std::byte> payload = framed(5);
    payload[static_cast<std::size_t>(place)] = static_cast<std::byte>(value);
    EXPECT_FALSE(messageInPayload(payload));
  }
}

}  // namespace pongsim::transport
