#include "shared/rtps/submessages.hh"

#include <gtest/gtest.h>

#include <initializer_list>
#include <vector>

namespace pongsim::shared {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes messageOf(std::initializer_list<std::uint8_t> parts) {
  Bytes message{'R', 'T', 'P', 'S', 2, 3, 1, 16};
  message.resize(Submessages::kMessageHeader, 7);
  message.insert(message.end(), parts);
  return message;
}

/// The contents of each.
std::vector<Bytes> contentsOf(const Bytes& message, bool isCutOff = false) {
  std::vector<Bytes> contents;
  Submessages parts(message);
  while (const auto part = parts.next()) contents.emplace_back(part->content.begin(), part->content.end());
  EXPECT_FALSE(parts.next());
  EXPECT_EQ(parts.isCutOff(), isCutOff);
  return contents;
}

TEST(Submessages, AreReadInOrder) {
  Bytes message = messageOf({0x0e, 1, 4, 0, 1, 2, 3, 4, 0x06, 2, 0, 8, 5, 6, 7, 8, 9, 10, 11, 12});
  Submessages parts(message);
  const auto first = parts.next();
  ASSERT_TRUE(first);
  EXPECT_EQ(first->kind, 0x0e);
  EXPECT_TRUE(first->isLittleEndian());
  EXPECT_EQ(Bytes(first->content.begin(), first->content.end()), (Bytes{1, 2, 3, 4}));
  const auto second = parts.next();
  ASSERT_TRUE(second);
  EXPECT_EQ(second->kind, 0x06);
  EXPECT_EQ(second->flags, 2);
  EXPECT_FALSE(second->isLittleEndian());
  EXPECT_EQ(second->content.size(), 8);
  EXPECT_FALSE(parts.next());
  EXPECT_EQ(second->content.data(), &message[32]) << "in the message";
}

TEST(Submessages, WithoutASizeGoOnToTheEnd) {
  EXPECT_EQ(contentsOf(messageOf({0x15, 1, 0, 0, 1, 2, 3, 4, 0x0e, 1, 0, 0})),
            (std::vector<Bytes>{{1, 2, 3, 4, 0x0e, 1, 0, 0}}));
  // padding, and the time where there is none (its flag 2)
  EXPECT_EQ(contentsOf(messageOf({0x01, 1, 0, 0, 0x09, 3, 0, 0, 0x0e, 1, 1, 0, 8})), (std::vector<Bytes>{{}, {}, {8}}));
}

TEST(Submessages, BeginAtMultiplesOfFour) {
  EXPECT_EQ(contentsOf(messageOf({0x0e, 1, 5, 0, 1, 2, 3, 4, 5, 0, 0, 0, 0x0f, 1, 1, 0, 6})),
            (std::vector<Bytes>{{1, 2, 3, 4, 5}, {6}}));
}

TEST(Submessages, EndWhereOneIsLongerThanTheMessage) {
  EXPECT_EQ(contentsOf(messageOf({0x0e, 1, 1, 0, 1, 0, 0, 0, 0x0f, 1, 5, 0, 1, 2, 3, 4}), true),
            (std::vector<Bytes>{{1}}));
  EXPECT_EQ(contentsOf(messageOf({0x0e, 1, 1}), true), std::vector<Bytes>{});
}

TEST(Submessages, AreNotInOtherBytes) {
  Bytes other = messageOf({0x0e, 1, 1, 0, 1});
  other[0] = 'r';
  EXPECT_FALSE(isRtpsMessage(other));
  EXPECT_EQ(contentsOf(other), std::vector<Bytes>{});
  Bytes cutOff = messageOf({});
  EXPECT_TRUE(isRtpsMessage(cutOff));
  cutOff.pop_back();
  cutOff.shrink_to_fit();
  EXPECT_FALSE(isRtpsMessage(cutOff));
  EXPECT_EQ(contentsOf(cutOff), std::vector<Bytes>{});
  EXPECT_EQ(contentsOf({}), std::vector<Bytes>{});
}

}  // namespace
}  // namespace pongsim::shared
