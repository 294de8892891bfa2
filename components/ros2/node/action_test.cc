#include "ros2/node/action.hh"

#include <gtest/gtest.h>

#include <future>
#include <mutex>
#include <optional>
#include <vector>

#include "support/process.hh"
#include "support/test_domain.hh"
#include "support/wait_until.hh"

namespace pongsim::ros2 {
namespace {

/// Like example_interfaces/action/Fibonacci.
struct Fibonacci {
  static constexpr const char* kName = "example_interfaces/action/Fibonacci";
  struct Goal {
    static constexpr const char* kName = "example_interfaces/action/Fibonacci_Goal";
    std::int32_t order = 0;
    static void visit(auto& self, auto&& field) { field("order", self.order); }
    bool operator==(const Goal&) const = default;
  };
  struct Result {
    static constexpr const char* kName = "example_interfaces/action/Fibonacci_Result";
    std::vector<std::int32_t> sequence;
    static void visit(auto& self, auto&& field) { field("sequence", self.sequence); }
    bool operator==(const Result&) const = default;
  };
  struct Feedback {
    static constexpr const char* kName = "example_interfaces/action/Fibonacci_Feedback";
    std::int32_t order = 0;
    std::vector<std::int32_t> sequence;
    static void visit(auto& self, auto&& field) {
      field("order", self.order);
      field("sequence", self.sequence);
    }
    bool operator==(const Feedback&) const = default;
  };
  struct OlderFeedback {
    static constexpr const char* kName = "example_interfaces/action/Fibonacci_Feedback";
    std::vector<std::int32_t> sequence;
    static void visit(auto& self, auto&& field) { field("sequence", self.sequence); }
    bool operator==(const OlderFeedback&) const = default;
  };
  static OlderFeedback toOlder(const Feedback& feedback) { return {feedback.sequence}; }
};

using Status = action_msgs::GoalStatus;
using Cancel = action_msgs::srv::CancelGoal;

/// Accepts goals of an order up to 50, keeps them until the test ends them, and agrees to cancel all except order 13.
class ActionTest : public testing::Test {
 protected:
  ActionTest() {
    server_.emplace(
        node_, "~/fibonacci",
        [] {
          return builtin_interfaces::Time{5, 6};
        },
        ActionServer<Fibonacci>::Handlers{
            .accepts = [](const Fibonacci::Goal& goal) { return goal.order <= 50; },
            .execute = [this](const Goals::Id& id, const Fibonacci::Goal& goal) { goals_[id.uuid[0]] = goal.order; },
            .cancels = [this](const Goals::Id& id) { return goals_.at(id.uuid[0]) != 13; }});
  }

  static Goals::Id idOf(std::uint8_t number) {
    Goals::Id id;
    id.uuid[0] = number;
    return id;
  }
  template <class Service>
  std::future<std::optional<typename Service::Response>> start(const std::string& service,
                                                               const typename Service::Request& request) {
    return std::async(std::launch::async, [this, service, request] {
      return RosClient<Service>(peer_, "/pongsim/fibonacci/_action/" + service).call(request, test::kDeadline);
    });
  }
  template <class Future>
  auto get(Future future) {
    test::waitUntil([&] {
      node_.mailbox().dispatch();
      return future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    });
    return future.get().value();
  }
  template <class Service>
  typename Service::Response call(const std::string& service, const typename Service::Request& request) {
    return get(start<Service>(service, request));
  }
  bool send(std::uint8_t id, std::int32_t order) {
    return call<SendGoal<Fibonacci>>("send_goal", {idOf(id), {order}}).accepted;
  }
  GetResult<Fibonacci>::Response result(std::uint8_t id) {
    return call<GetResult<Fibonacci>>("get_result", {idOf(id)});
  }

  const int domain_ = test::testDomain();
  std::map<int, std::int32_t> goals_;
  Participant participant_{{.domain = domain_}};
  RosNode node_{participant_, {}};
  std::optional<ActionServer<Fibonacci>> server_;
  Participant peerParticipant_{{.domain = domain_}};
  RosNode peer_{peerParticipant_, {.name = "peer"}};
};

TEST_F(ActionTest, AGoalIsTakenOnce) {
  const auto response = call<SendGoal<Fibonacci>>("send_goal", {idOf(1), {7}});
  EXPECT_TRUE(response.accepted);
  EXPECT_EQ(response.stamp, (builtin_interfaces::Time{5, 6}));
  EXPECT_EQ(goals_, (std::map<int, std::int32_t>{{1, 7}}));
  EXPECT_FALSE(send(1, 8));
  EXPECT_FALSE(send(2, 51));
  EXPECT_EQ(goals_.size(), 1);
}

TEST_F(ActionTest, WhoAsksForTheResultGetsItWhenItIsThereAndLater) {
  ASSERT_TRUE(send(1, 3));
  ASSERT_TRUE(send(2, 3));
  auto early = start<GetResult<Fibonacci>>("get_result", {idOf(1)});
  // the same service answers it after the earlier one
  EXPECT_EQ(result(99).status, Status::kStatusUnknown);
  server_->end(idOf(1), Status::kStatusSucceeded, {{1, 1, 2}});
  server_->end(idOf(1), Status::kStatusAborted, {});
  const auto response = get(std::move(early));
  EXPECT_EQ(response.status, Status::kStatusSucceeded);
  EXPECT_EQ(response.result.sequence, (std::vector<std::int32_t>{1, 1, 2}));
  EXPECT_EQ(result(1), response);
  server_->end(idOf(2), Status::kStatusAborted, {{1}});
  EXPECT_EQ(result(2).status, Status::kStatusAborted);
}

TEST_F(ActionTest, CancellingIsAgreedToOrNot) {
  ASSERT_TRUE(send(1, 3) && send(2, 13));
  EXPECT_EQ(call<Cancel>("cancel_goal", {{idOf(9), {}}}).return_code, Cancel::Response::kErrorUnknownGoalId);
  EXPECT_EQ(call<Cancel>("cancel_goal", {{idOf(2), {}}}).return_code, Cancel::Response::kErrorRejected);
  EXPECT_FALSE(server_->isCanceling(idOf(1)));
  const auto all = call<Cancel>("cancel_goal", {});
  EXPECT_EQ(all.return_code, Cancel::Response::kErrorNone);
  ASSERT_EQ(all.goals_canceling.size(), 1);
  EXPECT_EQ(all.goals_canceling[0].goal_id, idOf(1));
  EXPECT_TRUE(server_->isCanceling(idOf(1)));
  server_->end(idOf(1), Status::kStatusCanceled, {{1}});
  EXPECT_EQ(result(1).status, Status::kStatusCanceled);
  EXPECT_EQ(call<Cancel>("cancel_goal", {{idOf(1), {}}}).return_code, Cancel::Response::kErrorGoalTerminated);
}

TEST_F(ActionTest, FeedbackAndStatusAreTold) {
  using Older = FeedbackMessage<Fibonacci, Fibonacci::OlderFeedback>;
  std::mutex mutex;
  std::vector<FeedbackMessage<Fibonacci>> feedback;
  std::vector<Older> olderFeedback;
  std::vector<action_msgs::GoalStatusArray> statuses;
  const auto feedbackReader = peer_.subscribe<FeedbackMessage<Fibonacci>>(
      "/pongsim/fibonacci/_action/feedback", [&](const FeedbackMessage<Fibonacci>& message) {
        const std::lock_guard lock(mutex);
        feedback.push_back(message);
      });
  const auto olderReader = peer_.subscribe<Older>("/pongsim/fibonacci/_action/feedback", [&](const Older& message) {
    const std::lock_guard lock(mutex);
    olderFeedback.push_back(message);
  });
  ASSERT_TRUE(send(4, 3));
  ASSERT_TRUE(test::waitUntil([&] {
    server_->publishFeedback(idOf(4), {3, {1, 1}});
    const std::lock_guard lock(mutex);
    return !feedback.empty() && !olderFeedback.empty();
  }));
  // each in the version of its type, and in no other
  for (const auto& each : feedback) EXPECT_EQ(each, (FeedbackMessage<Fibonacci>{idOf(4), {3, {1, 1}}}));
  for (const auto& each : olderFeedback) EXPECT_EQ(each, (Older{idOf(4), {{1, 1}}}));
  EXPECT_EQ(peer_.malformed(), 0);
  server_->end(idOf(4), Status::kStatusSucceeded, {});
  // late subscribers get the last status
  const auto statusReader = peer_.subscribe<action_msgs::GoalStatusArray>(
      "/pongsim/fibonacci/_action/status",
      [&](const action_msgs::GoalStatusArray& message) {
        const std::lock_guard lock(mutex);
        statuses.push_back(message);
      },
      kLatchedQos);
  ASSERT_TRUE(test::waitUntil([&] {
    const std::lock_guard lock(mutex);
    return !statuses.empty();
  }));
  ASSERT_EQ(statuses.back().status_list.size(), 1);
  EXPECT_EQ(statuses.back().status_list[0].goal_info.goal_id, idOf(4));
  EXPECT_EQ(statuses.back().status_list[0].status, Status::kStatusSucceeded);
}

}  // namespace
}  // namespace pongsim::ros2
