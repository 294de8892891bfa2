#include "web/server/client_queue.hh"

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pongsim::web {
namespace {

class ClientQueueTest : public testing::Test {
 protected:
  void send(std::uint64_t key, std::size_t most, const std::string& text) {
    queue_.addData(key, most, {.head = text, .body = {}});
  }
  bool say(const std::string& text) { return queue_.add({.isText = true, .frame = {.head = text, .body = {}}}); }
  std::vector<std::string> all() {
    std::vector<std::string> texts;
    while (const std::optional<ClientQueue::Item> item = queue_.take()) texts.push_back(item->frame.head);
    return texts;
  }

  ServerLimits limits_{.waitingBytes = 10, .waitingKeys = 3, .waitingMessages = 4};
  ClientQueue queue_{limits_};
};

using Texts = std::vector<std::string>;

TEST_F(ClientQueueTest, OnlyTheLatestWaitsWhereOneMay) {
  send(1, 1, "a");
  send(1, 1, "b");
  send(1, 1, "c");
  EXPECT_EQ(all(), Texts{"c"});
  EXPECT_EQ(queue_.dropped(), 2U);
}

TEST_F(ClientQueueTest, TheLatestTakesThePlaceOfTheOneBefore) {
  send(1, 1, "a");
  send(2, 1, "x");
  send(1, 1, "b");
  EXPECT_EQ(all(), (Texts{"b", "x"}));
}

TEST_F(ClientQueueTest, KeysTakeTurns) {
  for (const char* text : {"a", "b", "c"}) send(1, 5, text);
  for (const char* text : {"x", "y"}) send(2, 5, text);
  EXPECT_EQ(all(), (Texts{"a", "x", "b", "y", "c"}));
}

TEST_F(ClientQueueTest, TheOldestGoesWhereMoreWaitThanMay) {
  for (const char* text : {"a", "b", "c"}) send(1, 2, text);
  EXPECT_EQ(all(), (Texts{"b", "c"}));
}

TEST_F(ClientQueueTest, WhatMustNotBeLostLeavesFirstAndInOrder) {
  send(1, 1, "data");
  EXPECT_TRUE(say("one"));
  EXPECT_TRUE(say("two"));
  EXPECT_EQ(all(), (Texts{"one", "two", "data"}));
}

TEST_F(ClientQueueTest, DataBeyondTheLimitIsDroppedAndCounted) {
  send(1, 1, "123456");
  send(2, 1, "123456");
  EXPECT_EQ(all(), Texts{"123456"});
  EXPECT_EQ(queue_.dropped(), 1U);
  // there is room again
  send(2, 1, "123456");
  EXPECT_EQ(all(), Texts{"123456"});
}

TEST_F(ClientQueueTest, ALatestThatIsTooLargeLeavesNothingOldBehind) {
  send(1, 1, "old");
  send(1, 1, std::string(11, 'x'));
  EXPECT_TRUE(queue_.isEmpty());
  EXPECT_EQ(all(), Texts{});
  EXPECT_EQ(queue_.dropped(), 2U);
}

TEST_F(ClientQueueTest, KeysBeyondTheLimitAreDropped) {
  for (const std::uint64_t key : {1, 2, 3, 4}) send(key, 1, std::to_string(key));
  EXPECT_EQ(all(), (Texts{"1", "2", "3"}));
}

TEST_F(ClientQueueTest, RefusesWhatMustNotBeLostBeyondTheLimit) {
  EXPECT_TRUE(say("1234567890"));
  EXPECT_FALSE(say("x"));
}

TEST_F(ClientQueueTest, RefusesMoreMessagesThanMayWaitHoweverSmallTheyAre) {
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(say(""));
  EXPECT_FALSE(say(""));
}

TEST_F(ClientQueueTest, MakesWhatIsMadeWhenItLeaves) {
  int state = 1;
  queue_.addMaker(1, [&state] { return Frame{.head = std::to_string(state), .body = {}}; });
  queue_.addMaker(2, [] { return Frame{}; });
  state = 2;
  EXPECT_EQ(all(), Texts{"2"});
  queue_.addMaker(1, [] { return Frame{.head = "{}", .body = {}, .isText = true}; });
  EXPECT_TRUE(queue_.take().value().isText);
}

TEST_F(ClientQueueTest, ForgetsAKey) {
  send(1, 2, "12345");
  send(2, 1, "x");
  queue_.forget(1);
  queue_.forget(7);
  EXPECT_EQ(all(), Texts{"x"});
  send(1, 1, "1234567890");
  EXPECT_EQ(all(), Texts{"1234567890"});
}

TEST_F(ClientQueueTest, IsEmptyOnceCleared) {
  say("1234567890");
  send(1, 1, "1234567890");
  queue_.clear();
  EXPECT_TRUE(queue_.isEmpty());
  EXPECT_TRUE(say("1234567890"));
}

}  // namespace
}  // namespace pongsim::web
