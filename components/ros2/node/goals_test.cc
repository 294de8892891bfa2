#include "ros2/node/goals.hh"

#include <gtest/gtest.h>

#include <vector>

namespace pongsim::ros2 {
namespace {

using Status = action_msgs::GoalStatus;
using CancelResponse = action_msgs::srv::CancelGoal::Response;

/// Five goals, accepted at 1 to 5 s: the second has succeeded, the third is being cancelled.
class GoalsTest : public testing::Test {
 protected:
  GoalsTest() {
    for (std::uint8_t i = 1; i <= 5; ++i) EXPECT_TRUE(goals_.accept(idOf(i), {i, 0}));
    goals_.end(idOf(2), Status::kStatusSucceeded, start_);
    goals_.startCanceling(idOf(3));
  }
  static Goals::Id idOf(std::uint8_t number) {
    Goals::Id id;
    id.uuid[15] = number;
    return id;
  }
  std::vector<int> meant(const Goals::Id& id, const Goals::Time& stamp) const {
    std::vector<int> numbers;
    for (const auto& info : goals_.toCancel({id, stamp}).goals) numbers.push_back(info.goal_id.uuid[15]);
    return numbers;
  }

  const Goals::Clock::time_point start_;
  Goals goals_;
};

TEST_F(GoalsTest, HaveStates) {
  EXPECT_EQ(goals_.status(idOf(1)), Status::kStatusExecuting);
  EXPECT_EQ(goals_.status(idOf(2)), Status::kStatusSucceeded);
  EXPECT_EQ(goals_.status(idOf(3)), Status::kStatusCanceling);
  EXPECT_EQ(goals_.status(idOf(9)), Status::kStatusUnknown);
  EXPECT_EQ(goals_.stamp(idOf(4)), (Goals::Time{4, 0}));
  ASSERT_EQ(goals_.statuses().status_list.size(), 5);
  EXPECT_EQ(goals_.statuses().status_list[1].status, Status::kStatusSucceeded);
}

TEST_F(GoalsTest, AnIdIsTakenOnce) {
  EXPECT_FALSE(goals_.accept(idOf(2), {9, 0}));
  EXPECT_EQ(goals_.stamp(idOf(2)), (Goals::Time{2, 0}));
}

TEST_F(GoalsTest, WhatHasEndedStaysAsItEnded) {
  goals_.end(idOf(2), Status::kStatusAborted, start_);
  goals_.startCanceling(idOf(2));
  EXPECT_EQ(goals_.status(idOf(2)), Status::kStatusSucceeded);
}

TEST_F(GoalsTest, AreCancelledByIdAndTime) {
  EXPECT_EQ(meant({}, {}), (std::vector{1, 4, 5}));
  EXPECT_EQ(meant(idOf(4), {}), (std::vector{4}));
  EXPECT_EQ(meant({}, {4, 0}), (std::vector{1, 4}));
  EXPECT_EQ(meant({}, {0, 999}), (std::vector<int>{}));
  EXPECT_EQ(meant(idOf(5), {3, 0}), (std::vector{1, 5}));
  EXPECT_EQ(meant(idOf(99), {3, 0}), (std::vector{1}));
}

TEST_F(GoalsTest, WhoCannotBeCancelledIsAnError) {
  EXPECT_EQ(goals_.toCancel({idOf(99), {}}).code, CancelResponse::kErrorUnknownGoalId);
  EXPECT_EQ(goals_.toCancel({idOf(2), {}}).code, CancelResponse::kErrorGoalTerminated);
  EXPECT_EQ(goals_.toCancel({idOf(1), {}}).code, CancelResponse::kErrorNone);
}

TEST_F(GoalsTest, AreForgottenAWhileAfterTheyHaveEnded) {
  EXPECT_TRUE(goals_.forget(start_ + Goals::kKept - std::chrono::seconds(1)).empty());
  EXPECT_EQ(goals_.forget(start_ + Goals::kKept), (std::vector{idOf(2)}));
  EXPECT_EQ(goals_.status(idOf(2)), Status::kStatusUnknown);
  EXPECT_EQ(goals_.statuses().status_list.size(), 4);
  EXPECT_TRUE(goals_.accept(idOf(2), {9, 0}));
}

TEST_F(GoalsTest, OfManyTheOldestAreForgotten) {
  for (std::size_t i = 0; i < Goals::kMostKept; ++i) {
    Goals::Id id;
    id.uuid[0] = static_cast<std::uint8_t>(i >> 8 | 0x80);
    id.uuid[1] = static_cast<std::uint8_t>(i);
    goals_.accept(id, {10, 0});
    goals_.end(id, Status::kStatusAborted, start_);
  }
  EXPECT_EQ(goals_.forget(start_), (std::vector{idOf(2)}));
}

}  // namespace
}  // namespace pongsim::ros2
