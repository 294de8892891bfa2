#include "ros2/services/run_requests.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/world_control.pb.h>

#include <vector>

namespace pongsim::ros2::run_requests_test {
namespace {

namespace si = simulation_interfaces;
using ignition::msgs::WorldControl;
using State = si::SimulationState;
using Set = si::srv::SetSimulationState::Response;

/// Requests to a run that the test plays itself. run_services_test.cc tests that of `pongsim run`.
class RunRequestsTest : public testing::Test {
 protected:
  void offerControl() {
    control_ = transport_.node().serve<WorldControl, ignition::msgs::Boolean>(
        "/world/w/control", [this](const WorldControl& request, ignition::msgs::Boolean&) -> ServiceAnswer {
          asked_.push_back(request);
          if (!refusal_.empty()) return ServiceAnswer::refused(refusal_);
          return true;
        });
  }
  void paused(std::uint64_t iteration) { run_.preUpdate({.dt = Time(0), .iteration = iteration, .paused = true}); }
  void playing(std::uint64_t iteration) { run_.preUpdate({.dt = Time(1), .iteration = iteration, .paused = false}); }
  RunRequests::Done note() {
    return [this](const Result& result) { results_.push_back(result); };
  }

  Transport transport_{{.network = false, .domain = {}}};
  RunRequests run_{transport_.node(), ServiceNames("~", "w")};
  Service control_;
  std::vector<WorldControl> asked_;
  std::string refusal_;
  std::vector<Result> results_;
};

TEST_F(RunRequestsTest, SayWhereNobodyRunsIt) {
  paused(0);
  EXPECT_FALSE(run_.canBeAsked());
  run_.setState(State::kStatePlaying, note());
  run_.setState(State::kStateQuitting, note());
  run_.step(1, note());
  run_.resetAll(false, note());
  ASSERT_EQ(results_.size(), 4U);
  EXPECT_EQ(results_[0].result, Set::kStateTransitionError);
  EXPECT_EQ(results_[1].result, Set::kStateTransitionError);
  EXPECT_EQ(results_[2].result, Result::kResultOperationFailed);
  EXPECT_EQ(results_[3].result, Result::kResultOperationFailed);
  // no other request is stepping
  run_.step(1, note());
  EXPECT_EQ(results_.back(), results_[2]);
}

TEST_F(RunRequestsTest, PassOnWhyItIsRefused) {
  offerControl();
  refusal_ = "not now";
  paused(0);
  run_.setState(State::kStatePlaying, note());
  run_.step(1, note());
  EXPECT_TRUE(results_.empty());
  transport_.dispatch();
  ASSERT_EQ(results_.size(), 2U);
  EXPECT_EQ(results_[0].result, Set::kStateTransitionError);
  EXPECT_NE(results_[0].error_message.find("not now"), std::string::npos) << results_[0].error_message;
  EXPECT_EQ(results_[1].result, Result::kResultOperationFailed);
}

TEST_F(RunRequestsTest, AnswerWhenTheLastStepIsMadeAndItIsPausedAgain) {
  offerControl();
  paused(10);
  run_.step(3, note());
  transport_.dispatch();
  ASSERT_EQ(asked_.size(), 1U);
  EXPECT_TRUE(asked_[0].pause());
  EXPECT_EQ(asked_[0].multi_step(), 3U);
  for (const std::uint64_t iteration : {11, 12, 13}) {
    playing(iteration);
    EXPECT_EQ(run_.state(), State::kStatePlaying);
    EXPECT_TRUE(results_.empty());
  }
  paused(13);
  EXPECT_EQ(results_, std::vector<Result>{succeeded()});
  EXPECT_EQ(run_.state(), State::kStatePaused);
}

TEST_F(RunRequestsTest, SayThatSomebodyLetItGoOn) {
  offerControl();
  paused(0);
  run_.step(1, note());
  transport_.dispatch();
  playing(1);
  playing(2);
  EXPECT_EQ(results_, std::vector<Result>{failed("the simulation was resumed meanwhile")});
}

TEST_F(RunRequestsTest, StayPausedAfterAResetAmongSteps) {
  offerControl();
  paused(0);
  run_.step(5, note());
  transport_.dispatch();
  playing(1);
  run_.resetAll(false, note());
  transport_.dispatch();
  ASSERT_EQ(asked_.size(), 2U);
  EXPECT_TRUE(asked_[1].pause());
  EXPECT_TRUE(asked_[1].reset().all());
}

TEST_F(RunRequestsTest, StayPausedAfterAResetAmongStepsOfOthers) {
  offerControl();
  playing(1);
  run_.resetAll(true, note());
  run_.resetAll(false, note());
  transport_.dispatch();
  ASSERT_EQ(asked_.size(), 2U);
  EXPECT_TRUE(asked_[0].pause());
  EXPECT_FALSE(asked_[1].pause());
}

}  // namespace
}  // namespace pongsim::ros2::run_requests_test
