#include "web/server/outbox.hh"

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pongsim::web {
namespace {

class OutboxTest : public testing::Test {
 protected:
  void send(std::uint64_t key, std::size_t most, const std::string& text) {
    outbox_.addData(key, most, {.head = text, .body = {}});
  }
  bool say(const std::string& text) { return outbox_.add({.isText = true, .frame = {.head = text, .body = {}}}); }
  std::vector<std::string> all() {
    std::vector<std::string> texts;
    while (const std::optional<Outbox::Item> item = outbox_.take()) texts.push_back(item->frame.head);
    return texts;
  }

  ServerLimits limits_{.waitingBytes = 10, .waitingKeys = 3, .waitingMessages = 4};
  Outbox outbox_{limits_};
};

using Texts = std::vector<std::string>;

TEST_F(OutboxTest, OnlyTheLatestWaitsWhereOneMay) {
  send(1, 1, "a");
  send(1, 1, "b");
  send(1, 1, "c");
  EXPECT_EQ(all(), Texts{"c"});
  EXPECT_EQ(outbox_.dropped(), 2U);
}

TEST_F(OutboxTest, TheLatestTakesThePlaceOfTheOneBefore) {
  send(1, 1, "a");
  send(2, 1, "x");
  send(1, 1, "b");
  EXPECT_EQ(all(), (Texts{"b", "x"}));
}

TEST_F(OutboxTest, KeysTakeTurns) {
  for (const char* text : {"a", "b", "c"}) send(1, 5, text);
  for (const char* text : {"x", "y"}) send(2, 5, text);
  EXPECT_EQ(all(), (Texts{"a", "x", "b", "y", "c"}));
}

TEST_F(OutboxTest, TheOldestGoesWhereMoreWaitThanMay) {
  for (const char* text : {"a", "b", "c"}) send(1, 2, text);
  EXPECT_EQ(all(), (Texts{"b", "c"}));
}

TEST_F(OutboxTest, WhatMustNotBeLostLeavesFirstAndInOrder) {
  send(1, 1, "data");
  EXPECT_TRUE(say("one"));
  EXPECT_TRUE(say("two"));
  EXPECT_EQ(all(), (Texts{"one", "two", "data"}));
}

TEST_F(OutboxTest, DataBeyondTheLimitIsDroppedAndCounted) {
  send(1, 1, "123456");
  send(2, 1, "123456");
  EXPECT_EQ(all(), Texts{"123456"});
  EXPECT_EQ(outbox_.dropped(), 1U);
  // there is room again
  send(2, 1, "123456");
  EXPECT_EQ(all(), Texts{"123456"});
}

TEST_F(OutboxTest, ALatestThatIsTooLargeLeavesNothingOldBehind) {
  send(1, 1, "old");
  send(1, 1, std::string(11, 'x'));
  EXPECT_TRUE(outbox_.isEmpty());
  EXPECT_EQ(all(), Texts{});
  EXPECT_EQ(outbox_.dropped(), 2U);
}

TEST_F(OutboxTest, KeysBeyondTheLimitAreDropped) {
  for (const std::uint64_t key : {1, 2, 3, 4}) send(key, 1, std::to_string(key));
  EXPECT_EQ(all(), (Texts{"1", "2", "3"}));
}

TEST_F(OutboxTest, RefusesWhatMustNotBeLostBeyondTheLimit) {
  EXPECT_TRUE(say("1234567890"));
  EXPECT_FALSE(say("x"));
}

TEST_F(OutboxTest, RefusesMoreMessagesThanMayWaitHoweverSmallTheyAre) {
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(say(""));
  EXPECT_FALSE(say(""));
}

TEST_F(OutboxTest, MakesWhatIsMadeWhenItLeaves) {
  int state = 1;
  outbox_.addMaker(1, [&state] { return Frame{.head = std::to_string(state), .body = {}}; });
  outbox_.addMaker(2, [] { return Frame{}; });
  state = 2;
  EXPECT_EQ(all(), Texts{"2"});
}

TEST_F(OutboxTest, ForgetsAKey) {
  send(1, 2, "12345");
  send(2, 1, "x");
  outbox_.forget(1);
  outbox_.forget(7);
  EXPECT_EQ(all(), Texts{"x"});
  send(1, 1, "1234567890");
  EXPECT_EQ(all(), Texts{"1234567890"});
}

TEST_F(OutboxTest, IsEmptyOnceCleared) {
  say("1234567890");
  send(1, 1, "1234567890");
  outbox_.clear();
  EXPECT_TRUE(outbox_.isEmpty());
  EXPECT_TRUE(say("1234567890"));
}

}  // namespace
}  // namespace pongsim::web
