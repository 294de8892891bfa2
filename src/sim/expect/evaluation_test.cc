#include "sim/expect/evaluation.hh"

#include <gtest/gtest.h>

namespace pongsim::sim {
namespace {

using Mode = Expectation::Mode;
using Reason = Evaluation::Reason;
using Role = Evaluation::Role;
using State = Verdict::State;

constexpr Time s(double seconds) { return fromSeconds(seconds); }

Expectation expectation(Mode mode, std::size_t events = 1) {
  Expectation result;
  result.mode = mode;
  result.events.resize(events);
  return result;
}

TEST(Evaluation, EventuallyIsMetByTheFirstValueThatHolds) {
  Expectation expected = expectation(Mode::kEventually);
  expected.to = s(2);
  Evaluation evaluation(expected);
  EXPECT_TRUE(evaluation.see(Role::kEvent, 0, s(1), false));
  EXPECT_FALSE(evaluation.isDecided());
  evaluation.see(Role::kEvent, 0, s(2), true);
  EXPECT_EQ(evaluation.state(), State::kMet);
  EXPECT_EQ(evaluation.decidedAt(), s(2));
  EXPECT_FALSE(evaluation.see(Role::kEvent, 0, s(2), true)) << "it is decided";
}

TEST(Evaluation, EventuallyFailsAfterItsTime) {
  Expectation expected = expectation(Mode::kEventually);
  expected.to = s(2);
  Evaluation evaluation(expected);
  evaluation.advance(s(2));
  EXPECT_FALSE(evaluation.isDecided()) << "a value at 2 s may still come";
  evaluation.see(Role::kEvent, 0, s(2.1), true);
  EXPECT_EQ(evaluation.state(), State::kFailed);
  EXPECT_EQ(evaluation.decidedAt(), s(2));
  EXPECT_EQ(evaluation.reason(), Reason::kTooLate);
}

TEST(Evaluation, ValuesBeforeTheWindowDoNotCount) {
  Expectation expected = expectation(Mode::kEventually);
  expected.from = s(1);
  Evaluation evaluation(expected);
  EXPECT_FALSE(evaluation.see(Role::kEvent, 0, s(0.9), true));
  EXPECT_FALSE(evaluation.isDecided());
  evaluation.end(s(3));
  EXPECT_EQ(evaluation.reason(), Reason::kTooLate);
}

TEST(Evaluation, EventuallyForATimeMustHoldOnEnd) {
  Expectation expected = expectation(Mode::kEventually);
  expected.hold = s(1);
  expected.to = s(5);
  Evaluation evaluation(expected);
  evaluation.see(Role::kEvent, 0, s(0), true);
  evaluation.see(Role::kEvent, 0, s(0.9), false);
  evaluation.see(Role::kEvent, 0, s(2), true);
  evaluation.advance(s(2.9));
  EXPECT_FALSE(evaluation.isDecided());
  evaluation.advance(s(3));
  EXPECT_EQ(evaluation.state(), State::kMet);
  EXPECT_EQ(evaluation.decidedAt(), s(3));
}

TEST(Evaluation, EventuallyForATimeMustBeDoneInTime) {
  Expectation expected = expectation(Mode::kEventually);
  expected.hold = s(1);
  expected.to = s(2);
  Evaluation evaluation(expected);
  evaluation.see(Role::kEvent, 0, s(1.5), true);
  evaluation.advance(s(3));
  EXPECT_EQ(evaluation.state(), State::kFailed);
}

TEST(Evaluation, AlwaysFailsWithTheFirstValueThatDoesNotHold) {
  Expectation expected = expectation(Mode::kAlways);
  Evaluation evaluation(expected);
  evaluation.see(Role::kEvent, 0, s(1), true);
  evaluation.see(Role::kEvent, 0, s(2), false);
  EXPECT_EQ(evaluation.state(), State::kFailed);
  EXPECT_EQ(evaluation.decidedAt(), s(2));
  EXPECT_EQ(evaluation.reason(), Reason::kViolated);
}

TEST(Evaluation, AlwaysIsMetAtTheEndOfItsWindow) {
  Expectation expected = expectation(Mode::kAlways);
  expected.to = s(2);
  Evaluation evaluation(expected);
  evaluation.see(Role::kEvent, 0, s(1), true);
  evaluation.see(Role::kEvent, 0, s(2.5), false);
  EXPECT_EQ(evaluation.state(), State::kMet);
  EXPECT_EQ(evaluation.decidedAt(), s(2));
}

TEST(Evaluation, AlwaysNeedsAValue) {
  const Expectation expected = expectation(Mode::kAlways);
  Evaluation evaluation(expected);
  evaluation.end(s(2));
  EXPECT_EQ(evaluation.state(), State::kFailed);
  EXPECT_EQ(evaluation.reason(), Reason::kNoValue);
}

TEST(Evaluation, AtAMomentTheFirstValueFromThenOnCounts) {
  Expectation expected = expectation(Mode::kAlways);
  expected.from = s(1);
  expected.to = s(1);
  for (const bool holds : {true, false}) {
    Evaluation evaluation(expected);
    evaluation.see(Role::kEvent, 0, s(0.9), !holds);
    evaluation.advance(s(1.1));
    evaluation.see(Role::kEvent, 0, s(1.2), holds);
    EXPECT_EQ(evaluation.state(), holds ? State::kMet : State::kFailed);
    EXPECT_EQ(evaluation.decidedAt(), s(1.2));
  }
}

TEST(Evaluation, NeverIsMetByARunWithoutIt) {
  const Expectation expected = expectation(Mode::kNever);
  Evaluation without(expected);
  without.see(Role::kEvent, 0, s(1), false);
  without.end(s(2));
  EXPECT_EQ(without.state(), State::kMet);
  Evaluation with(expected);
  with.see(Role::kEvent, 0, s(1), true);
  EXPECT_EQ(with.state(), State::kFailed);
  EXPECT_EQ(with.reason(), Reason::kViolated);
}

TEST(Evaluation, TheWindowBeginsWithAnEvent) {
  Expectation expected = expectation(Mode::kEventually);
  expected.after = Event{};
  expected.to = s(1);
  Evaluation evaluation(expected);
  EXPECT_FALSE(evaluation.see(Role::kEvent, 0, s(1), true)) << "it is before the event";
  evaluation.see(Role::kAfter, 0, s(5), true);
  evaluation.see(Role::kAfter, 0, s(5.5), true);
  evaluation.see(Role::kEvent, 0, s(6), true);
  EXPECT_EQ(evaluation.state(), State::kMet);
  EXPECT_EQ(evaluation.decidedAt(), s(6));
}

TEST(Evaluation, AWindowThatNeverBeginsIsAFailure) {
  for (const Mode mode : {Mode::kEventually, Mode::kAlways, Mode::kNever}) {
    Expectation expected = expectation(mode);
    expected.after = Event{};
    Evaluation evaluation(expected);
    evaluation.end(s(1));
    EXPECT_EQ(evaluation.reason(), Reason::kNoStart);
  }
}

TEST(Evaluation, UntilEndsTheWindowJustBeforeItComes) {
  Expectation expected = expectation(Mode::kAlways);
  expected.until = Event{};
  // whichever is seen first at that time
  for (const bool untilFirst : {true, false}) {
    Evaluation evaluation(expected);
    evaluation.see(Role::kEvent, 0, s(1), true);
    if (untilFirst) evaluation.see(Role::kUntil, 0, s(2), true);
    evaluation.see(Role::kEvent, 0, s(2), false);
    if (!untilFirst) evaluation.see(Role::kUntil, 0, s(2), true);
    evaluation.advance(s(3));
    EXPECT_EQ(evaluation.state(), State::kMet) << untilFirst;
    EXPECT_EQ(evaluation.decidedAt(), s(2));
  }
}

TEST(Evaluation, AViolationBeforeUntilIsAFailure) {
  Expectation expected = expectation(Mode::kNever);
  expected.until = Event{};
  Evaluation evaluation(expected);
  evaluation.see(Role::kEvent, 0, s(1), true);
  evaluation.see(Role::kUntil, 0, s(2), true);
  EXPECT_EQ(evaluation.reason(), Reason::kViolated);
  EXPECT_EQ(evaluation.decidedAt(), s(1));
}

TEST(Evaluation, UntilMustCome) {
  Expectation expected = expectation(Mode::kAlways);
  expected.until = Event{};
  expected.to = s(2);
  Evaluation late(expected);
  late.see(Role::kEvent, 0, s(1), true);
  late.see(Role::kUntil, 0, s(3), true);
  EXPECT_EQ(late.reason(), Reason::kNoEnd);
  EXPECT_EQ(late.decidedAt(), s(2));
}

TEST(Evaluation, InOrderIsMetByEventsOneAfterAnother) {
  const Expectation expected = expectation(Mode::kInOrder, 3);
  Evaluation evaluation(expected);
  evaluation.see(Role::kEvent, 1, s(0.5), true);
  evaluation.see(Role::kEvent, 0, s(1), true);
  evaluation.see(Role::kEvent, 2, s(1.5), true);
  evaluation.see(Role::kEvent, 1, s(2), true);
  EXPECT_EQ(evaluation.reached(), (std::vector<Time>{s(1), s(2)}));
  evaluation.see(Role::kEvent, 2, s(2), true);
  EXPECT_EQ(evaluation.state(), State::kMet);
  EXPECT_EQ(evaluation.cameFirst(1), s(0.5));
}

TEST(Evaluation, InOrderFailsWithTheEventThatIsMissing) {
  Expectation expected = expectation(Mode::kInOrder, 2);
  expected.to = s(3);
  Evaluation evaluation(expected);
  evaluation.see(Role::kEvent, 1, s(1), true);
  evaluation.see(Role::kEvent, 0, s(2), true);
  evaluation.advance(s(4));
  EXPECT_EQ(evaluation.reason(), Reason::kTooLate);
  EXPECT_EQ(evaluation.reached().size(), 1U);
  EXPECT_EQ(evaluation.cameFirst(1), s(1));
}

}  // namespace
}  // namespace pongsim::sim
