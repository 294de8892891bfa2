#include "sim/running/run_control.hh"

#include <gtest/gtest.h>

namespace pongsim::sim {
namespace {

using std::chrono::milliseconds;

TEST(RunControl, BeginsAsToldAndPausesAndGoesOn) {
  EXPECT_FALSE(RunControl(false).paused());
  RunControl control(true);
  EXPECT_TRUE(control.paused());
  EXPECT_TRUE(control.apply({}, Time::zero()));
  EXPECT_FALSE(control.paused());
  EXPECT_TRUE(control.apply({.pause = true}, Time::zero()));
  EXPECT_TRUE(control.paused());
}

TEST(RunControl, MakesTheStepsAskedForThenPauses) {
  RunControl control(true);
  control.apply({.pause = true, .steps = 3}, Time::zero());
  for (int i = 1; i <= 3; ++i) {
    EXPECT_FALSE(control.paused()) << i;
    control.stepped(milliseconds(i));
  }
  EXPECT_TRUE(control.paused());
}

TEST(RunControl, GoesOnWhereStepsAreAskedForWithoutAPause) {
  RunControl control(true);
  control.apply({.steps = 1}, Time::zero());
  for (int i = 1; i <= 5; ++i) control.stepped(milliseconds(i));
  EXPECT_FALSE(control.paused());
}

TEST(RunControl, LeavesTheRestOfTheStepsAtTheNextRequest) {
  RunControl control(true);
  control.apply({.pause = true, .steps = 100}, Time::zero());
  control.stepped(milliseconds(1));
  control.apply({.pause = true}, milliseconds(1));
  EXPECT_TRUE(control.paused());
}

TEST(RunControl, PausesBehindTheStepsThatAreLeftWhereItIsResetAmongThem) {
  RunControl control(true);
  control.apply({.pause = true, .steps = 5}, Time::zero());
  control.stepped(milliseconds(1));
  control.stepped(milliseconds(2));
  EXPECT_TRUE(control.apply({.reset = msgs::Reset::kAll}, Time::zero()));
  // the reset counts as one of the three steps
  for (int i = 1; i <= 2; ++i) {
    EXPECT_FALSE(control.paused()) << i;
    control.stepped(milliseconds(i));
  }
  EXPECT_TRUE(control.paused());
}

TEST(RunControl, PausesAtOnceWhereThatComesWithAResetAmongSteps) {
  RunControl control(true);
  control.apply({.pause = true, .steps = 5}, Time::zero());
  control.stepped(milliseconds(1));
  control.apply({.pause = true, .reset = msgs::Reset::kAll}, Time::zero());
  EXPECT_TRUE(control.paused());
}

TEST(RunControl, GoesOnAfterAResetWhereNoStepsAreLeft) {
  RunControl control(true);
  control.apply({.reset = msgs::Reset::kAll}, Time::zero());
  for (int i = 1; i <= 5; ++i) control.stepped(milliseconds(i));
  EXPECT_FALSE(control.paused());
}

TEST(RunControl, PausesAtATimeThatComesBeforeTheStepsAreMade) {
  RunControl control(true);
  control.apply({.pause = true, .steps = 9}, Time::zero());
  control.stepped(milliseconds(1));
  control.apply({.runTo = milliseconds(2), .reset = msgs::Reset::kAll}, Time::zero());
  control.stepped(milliseconds(1));
  EXPECT_FALSE(control.paused());
  control.stepped(milliseconds(2));
  EXPECT_TRUE(control.paused());
}

TEST(RunControl, PausesAtTheTimeAskedFor) {
  RunControl control(true);
  control.apply({.runTo = milliseconds(3)}, Time::zero());
  for (int i = 1; i <= 2; ++i) control.stepped(milliseconds(i));
  EXPECT_FALSE(control.paused());
  control.stepped(milliseconds(3));
  EXPECT_TRUE(control.paused());
  control.apply({}, milliseconds(3));
  control.stepped(milliseconds(4));
  EXPECT_FALSE(control.paused());
}

TEST(RunControl, ForgetsTheTimeAtTheNextRequestOrWhereItHasPassed) {
  RunControl control(false);
  control.apply({.runTo = milliseconds(3)}, Time::zero());
  control.apply({}, Time::zero());
  control.stepped(milliseconds(5));
  EXPECT_FALSE(control.paused());
  control.apply({.runTo = milliseconds(5)}, milliseconds(5));
  control.stepped(milliseconds(6));
  EXPECT_FALSE(control.paused());
  control.apply({.pause = true, .runTo = milliseconds(9)}, milliseconds(6));
  control.apply({}, milliseconds(6));
  control.stepped(milliseconds(10));
  EXPECT_FALSE(control.paused());
}

TEST(RunControl, RefusesAllOfWhatItCannotDo) {
  RunControl control(true);
  EXPECT_FALSE(control.apply({.reset = msgs::Reset::kTimeOnly}, Time::zero()));
  EXPECT_FALSE(control.apply({.reset = msgs::Reset::kModelsOnly}, Time::zero()));
  EXPECT_FALSE(control.apply({.seed = 1}, Time::zero()));
  EXPECT_TRUE(control.apply({.pause = true, .reset = msgs::Reset::kAll, .seed = 1}, Time::zero()));
  EXPECT_TRUE(control.paused());
}

}  // namespace
}  // namespace pongsim::sim
