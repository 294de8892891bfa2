#include "ros2/wire/submessages.hh"

#include <gtest/gtest.h>

#include <array>
#include <initializer_list>
#include <vector>

namespace pongsim::ros2 {
namespace {

using Bytes = std::vector<unsigned char>;

Bytes messageOf(std::initializer_list<unsigned char> parts) {
  Bytes message{'R', 'T', 'P', 'S', 2, 3, 1, 16};
  message.resize(Submessages::kMessageHeader, 7);
  message.insert(message.end(), parts);
  return message;
}

/// The contents of each.
std::vector<Bytes> contentsOf(Bytes message) {
  std::vector<Bytes> contents;
  Submessages parts(message);
  while (const auto part = parts.next()) contents.emplace_back(part->content.begin(), part->content.end());
  EXPECT_FALSE(parts.next());
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
  // in the message
  second->content[0] = 99;
  EXPECT_EQ(message[32], 99);
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
  EXPECT_EQ(contentsOf(messageOf({0x0e, 1, 1, 0, 1, 0, 0, 0, 0x0f, 1, 5, 0, 1, 2, 3, 4})), (std::vector<Bytes>{{1}}));
  EXPECT_EQ(contentsOf(messageOf({0x0e, 1, 1})), std::vector<Bytes>{});
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

TEST(Submessages, HaveNumbersOfEitherByteOrder) {
  const std::array<unsigned char, 3> bytes{1, 2, 3};
  EXPECT_EQ(numberIn(bytes, false), 0x010203);
  EXPECT_EQ(numberIn(bytes, true), 0x030201);
  std::array<unsigned char, 3> written{};
  putNumber(written, false, 0x99010203);
  EXPECT_EQ(written, bytes);
  putNumber(written, true, 0x030201);
  EXPECT_EQ(written, bytes);
}

}  // namespace
}  // namespace pongsim::ros2
