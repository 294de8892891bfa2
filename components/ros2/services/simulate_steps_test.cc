#include "ros2/services/simulate_steps.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/world_control.pb.h>

#include <future>
#include <mutex>
#include <optional>
#include <vector>

#include "support/test_domain.hh"
#include "support/wait_until.hh"

namespace pongsim::ros2 {
namespace {

using Action = SimulateSteps::Action;
using Status = action_msgs::GoalStatus;
using Cancel = action_msgs::srv::CancelGoal;
using Code = simulation_interfaces::Result;

/// A world that is initially paused, run like `pongsim run` does, and a client.
class SimulateStepsTest : public testing::Test {
 protected:
  void offerControl() {
    control_ = transport_.node().serve<ignition::msgs::WorldControl, ignition::msgs::Boolean>(
        "/world/w/control", [this](const ignition::msgs::WorldControl& request, ignition::msgs::Boolean& reply) {
          isPaused_ = request.pause();
          stepsLeft_ = request.multi_step();
          reply.set_data(true);
          return ServiceAnswer(true);
        });
  }
  void turn() {
    transport_.dispatch();
    const bool isStep = !isPaused_ || stepsLeft_ > 0;
    if (isStep) ++iterations_;
    const StepInfo info{Time{1000 * iterations_}, Time{isStep ? 1000 : 0}, iterations_, !isStep};
    steps_.preUpdate(info);
    ros_.mailbox().dispatch();
    steps_.postUpdate(info);
    if (isStep && stepsLeft_ > 0) --stepsLeft_;
  }
  template <class Service>
  std::future<typename Service::Response> start(const std::string& service, const typename Service::Request& request) {
    return std::async(std::launch::async, [this, service, request] {
      return RosClient<Service>(peer_, "/pongsim/simulate_steps/_action/" + service)
          .call(request, test::kDeadline)
          .value();
    });
  }
  template <class Future>
  auto get(Future future) {
    test::waitUntil([&] {
      turn();
      return future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    });
    return future.get();
  }
  template <class Service>
  typename Service::Response call(const std::string& service, const typename Service::Request& request) {
    return get(start<Service>(service, request));
  }
  void send(std::uint8_t id, std::uint64_t steps) {
    EXPECT_TRUE(call<SendGoal<Action>>("send_goal", {idOf(id), {steps}}).accepted);
  }
  GetResult<Action>::Response result(std::uint8_t id) { return call<GetResult<Action>>("get_result", {idOf(id)}); }
  static Goals::Id idOf(std::uint8_t number) {
    Goals::Id id;
    id.uuid[0] = number;
    return id;
  }

  const int domain_ = test::testDomain();
  bool isPaused_ = true;
  std::uint64_t stepsLeft_ = 0;
  std::uint64_t iterations_ = 0;
  Transport transport_{{.network = false}};
  Service control_;
  Participant participant_{{.domain = domain_}};
  RosNode ros_{participant_, {}};
  SimulateSteps steps_{transport_.node(), "/world/w/control", ros_, "~/simulate_steps"};
  Participant peerParticipant_{{.domain = domain_}};
  RosNode peer_{peerParticipant_, {.name = "peer"}};
};

TEST_F(SimulateStepsTest, MakesSoManyStepsAndTellsOfEach) {
  offerControl();
  std::mutex mutex;
  std::vector<Action::Feedback> heard;
  const auto subscription = peer_.subscribe<FeedbackMessage<Action>>(
      "/pongsim/simulate_steps/_action/feedback",
      [&](const FeedbackMessage<Action>& message) {
        const std::lock_guard lock(mutex);
        heard.push_back(message.feedback);
      },
      kDefaultQos);
  ASSERT_TRUE(test::waitUntil([&] { return subscription->reader().writers() > 0; }));
  send(1, 5);
  const auto response = result(1);
  EXPECT_EQ(response.status, Status::kStatusSucceeded);
  EXPECT_EQ(response.result.result, (Code{Code::kResultOk, ""}));
  EXPECT_EQ(iterations_, 5);
  EXPECT_TRUE(isPaused_);
  ASSERT_TRUE(test::waitUntil([&] {
    const std::lock_guard lock(mutex);
    return !heard.empty() && heard.back().remaining_steps == 0;
  }));
  for (const Action::Feedback& each : heard) EXPECT_EQ(each.completed_steps + each.remaining_steps, 5);
  EXPECT_EQ(heard.back().completed_steps, 5);
  send(2, 3);
  EXPECT_EQ(result(2).status, Status::kStatusSucceeded);
  EXPECT_EQ(iterations_, 8);
}

TEST_F(SimulateStepsTest, IsRefusedWhereItIsNotPaused) {
  offerControl();
  isPaused_ = false;
  send(1, 5);
  const auto response = result(1);
  EXPECT_EQ(response.status, Status::kStatusAborted);
  EXPECT_EQ(response.result.result, (Code{Code::kResultOperationFailed, "the simulation is not paused"}));
}

TEST_F(SimulateStepsTest, TakesOneGoalAtATimeAndCancelsIt) {
  offerControl();
  send(1, 1'000'000'000'000);
  send(2, 5);
  EXPECT_EQ(result(2).result.result.error_message, "the simulation is not paused: another goal steps it");
  EXPECT_EQ(call<Cancel>("cancel_goal", {{idOf(1), {}}}).return_code, Cancel::Response::kErrorNone);
  const auto response = result(1);
  EXPECT_EQ(response.status, Status::kStatusCanceled);
  EXPECT_TRUE(response.result.result.error_message.starts_with("cancelled after "));
  EXPECT_TRUE(isPaused_);
  EXPECT_EQ(stepsLeft_, 0);
  send(3, 2);
  EXPECT_EQ(result(3).status, Status::kStatusSucceeded);
}

TEST_F(SimulateStepsTest, SaysWhoElseHasEndedIt) {
  offerControl();
  send(1, 1'000'000'000);
  turn();
  stepsLeft_ = 0;
  EXPECT_TRUE(result(1).result.result.error_message.starts_with("it was paused after "));
  send(2, 1'000'000'000);
  turn();
  steps_.reset();
  EXPECT_TRUE(result(2).result.result.error_message.starts_with("the world was reset after "));
  stepsLeft_ = 0;
  const std::uint64_t before = iterations_;
  send(3, 1'000'000'000);
  iterations_ = before + 999'999'999;
  isPaused_ = false;
  EXPECT_EQ(result(3).result.result.error_message, "the simulation was resumed meanwhile");
}

TEST_F(SimulateStepsTest, AGoalThatCannotBeMetIsAborted) {
  send(1, 5);
  EXPECT_EQ(result(1).result.result.error_message,
            "nothing controls this simulation: there is no service '/world/w/control'");
  send(2, 0);
  EXPECT_EQ(result(2).result.result.result, Code::kResultOperationFailed);
  EXPECT_EQ(iterations_, 0);
}

}  // namespace
}  // namespace pongsim::ros2
