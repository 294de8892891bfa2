#include "transport/services/service_payload.hh"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

namespace pongsim::transport {
namespace {

constexpr ParticipantId kSomebody{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 255};

template <class Header>
std::vector<std::byte> payloadOf(const Header& header, std::string_view message) {
  std::vector<std::byte> payload(headerSize(header) + message.size());
  const std::span<std::byte> place = writeHeader(header, payload);
  EXPECT_EQ(place.size(), message.size());
  std::memcpy(place.data(), message.data(), message.size());
  return payload;
}

std::string textOf(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

TEST(ServicePayload, TakesARequestThereAndBack) {
  const std::vector<std::byte> payload = payloadOf(RequestHeader{kSomebody, 0x0102030405060708}, "hello");
  std::span<const std::byte> rest = payload;
  const auto header = readRequestHeader(rest);
  ASSERT_TRUE(header);
  EXPECT_EQ(header->server, kSomebody);
  EXPECT_EQ(header->call, 0x0102030405060708U);
  EXPECT_EQ(textOf(rest), "hello");
}

TEST(ServicePayload, TakesAReplyThereAndBack) {
  for (const bool done : {false, true}) {
    const std::vector<std::byte> payload = payloadOf(ReplyHeader{kSomebody, 7, done, "no room"}, "x");
    std::span<const std::byte> rest = payload;
    const auto header = readReplyHeader(rest);
    ASSERT_TRUE(header);
    EXPECT_EQ(header->client, kSomebody);
    EXPECT_EQ(header->call, 7U);
    EXPECT_EQ(header->done, done);
    EXPECT_EQ(header->reason, "no room");
    EXPECT_EQ(textOf(rest), "x");
  }
}

TEST(ServicePayload, IsRefusedWhereItEndsTooSoon) {
  const std::vector<std::byte> request = payloadOf(RequestHeader{kSomebody, 1}, "");
  const std::vector<std::byte> reply = payloadOf(ReplyHeader{kSomebody, 1, true, "reason"}, "");
  for (std::size_t size = 0; size < request.size(); ++size) {
    std::span<const std::byte> part = std::span(request).first(size);
    EXPECT_FALSE(readRequestHeader(part)) << size;
  }
  for (std::size_t size = 0; size < reply.size(); ++size) {
    std::span<const std::byte> part = std::span(reply).first(size);
    EXPECT_FALSE(readReplyHeader(part)) << size;
  }
}

TEST(ServicePayload, IsRefusedWhereItsLengthOrOutcomeIsNone) {
  std::vector<std::byte> endless = payloadOf(ReplyHeader{kSomebody, 1, true, ""}, "");
  std::fill(endless.end() - 4, endless.end(), std::byte{0xff});
  std::span<const std::byte> payload = endless;
  EXPECT_FALSE(readReplyHeader(payload));
  std::vector<std::byte> undecided = payloadOf(ReplyHeader{kSomebody, 1, true, ""}, "");
  undecided[20] = std::byte{2};
  payload = undecided;
  EXPECT_FALSE(readReplyHeader(payload));
}

}  // namespace
}  // namespace pongsim::transport
