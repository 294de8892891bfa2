#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "ros2/node/goals.hh"
#include "ros2/node/node.hh"
#include "ros2/node/service.hh"
#include "ros2/types/action_types.hh"

namespace pongsim::ros2 {

/// Offers an action for the lifetime of this object: its three services and two topics, with rcl's quality of service.
/// Where there is an older version of its feedback, there are two publishers of feedback, one for the nodes of each.
/// Goals are passed to `Handlers::execute`, which reports their progress. For one thread, that of the node's mailbox.
template <ActionType Action>
class ActionServer {
 public:
  using Goal = typename Action::Goal;
  using Result = typename Action::Result;
  using Feedback = typename Action::Feedback;
  using Id = Goals::Id;
  using Status = action_msgs::GoalStatus;

  struct Handlers {
    /// @return Whether to accept the goal; empty: accept all. Not called for an id that was used before.
    std::function<bool(const Goal&)> accepts;
    /// Called with each accepted goal, after its client has got the answer. The goal ends with `end`, now or later.
    std::function<void(const Id&, const Goal&)> execute;
    /// @return Whether to cancel the goal; empty: never. The goal goes on until `end` reports that it was cancelled, or
    /// another outcome.
    std::function<bool(const Id&)> cancels;
  };

  /// @param now Time source for goals and cancelling.
  /// @throws std::invalid_argument for a bad name.
  ActionServer(RosNode& node, const std::string& name, std::function<builtin_interfaces::Time()> now, Handlers handlers)
      : now_(std::move(now)), handlers_(std::move(handlers)) {
    const RosNode::Quiet quiet(node);
    const std::string base = name + "/_action/";
    if constexpr (requires { typename Action::OlderFeedback; }) {
      // a version's hash tells who reads it
      const std::string newer = typeInfo<FeedbackMessage<Action>>().hash;
      feedback_ = node.advertise<FeedbackMessage<Action>>(base + "feedback", kDefaultQos, {},
                                                          [newer](const std::string& hash) { return hash == newer; });
      olderFeedback_ = node.advertise<FeedbackMessage<Action, typename Action::OlderFeedback>>(
          base + "feedback", kDefaultQos, {}, [newer](const std::string& hash) { return hash != newer; });
    } else {
      feedback_ = node.advertise<FeedbackMessage<Action>>(base + "feedback");
    }
    status_ = node.advertise<action_msgs::GoalStatusArray>(base + "status", kLatchedQos);
    sendGoal_ = serve<SendGoal<Action>>(
        node, base + "send_goal", [this](const auto& request, const auto& responder) { take(request, responder); });
    cancelGoal_ = serve<action_msgs::srv::CancelGoal>(
        node, base + "cancel_goal",
        [this](const auto& request, const auto& responder) { cancel(request.goal_info, responder); });
    getResult_ = serve<GetResult<Action>>(
        node, base + "get_result",
        [this](const auto& request, const auto& responder) { sendResult(request.goal_id, responder); });
  }
  ActionServer(const ActionServer&) = delete;
  ActionServer& operator=(const ActionServer&) = delete;

  /// @return Whether cancelling the goal was requested and agreed to.
  bool isCanceling(const Id& id) const { return goals_.status(id) == Status::kStatusCanceling; }

  /// Publishes feedback on a goal, if anybody subscribes.
  void publishFeedback(const Id& id, const Feedback& feedback) {
    if (!feedback_->hasReaders()) return;
    feedback_->publish(FeedbackMessage<Action>{id, feedback});
    if constexpr (requires { Action::toOlder(feedback); }) {
      using Older = FeedbackMessage<Action, typename Action::OlderFeedback>;
      olderFeedback_->publish(Older{id, Action::toOlder(feedback)});
    }
  }

  /// Ends a goal. Does nothing if it has ended.
  /// @param status kStatusSucceeded, kStatusCanceled or kStatusAborted.
  void end(const Id& id, std::int8_t status, const Result& result) {
    const auto found = records_.find(id.uuid);
    if (found == records_.end() || found->second.isOver) return;
    goals_.end(id, status, Goals::Clock::now());
    found->second.isOver = true;
    found->second.result = result;
    // the pending requests for the result
    for (const auto& each : std::exchange(found->second.waiting, {})) each.answer({status, result});
    publishStatus();
  }

 private:
  using ResultResponder = Responder<GetResult<Action>>;
  struct Record {
    bool isOver = false;
    Result result;
    std::deque<ResultResponder> waiting;
  };
  static constexpr std::size_t kMostWaiting = 100;

  void take(const typename SendGoal<Action>::Request& request, const Responder<SendGoal<Action>>& responder) {
    forget();
    const builtin_interfaces::Time stamp = now_();
    const bool isNew = goals_.status(request.goal_id) == Status::kStatusUnknown;
    if (!isNew || (handlers_.accepts && !handlers_.accepts(request.goal))) return responder.answer({false, stamp});
    goals_.accept(request.goal_id, stamp);
    records_[request.goal_id.uuid];
    responder.answer({true, stamp});
    publishStatus();
    handlers_.execute(request.goal_id, request.goal);
  }

  void cancel(const action_msgs::GoalInfo& goalInfo, const Responder<action_msgs::srv::CancelGoal>& responder) {
    using Response = action_msgs::srv::CancelGoal::Response;
    const Goals::ToCancel meant = goals_.toCancel(goalInfo);
    Response response;
    response.return_code = meant.code;
    for (const action_msgs::GoalInfo& goal : meant.goals) {
      if (!handlers_.cancels || !handlers_.cancels(goal.goal_id)) continue;
      goals_.startCanceling(goal.goal_id);
      response.goals_canceling.push_back(goal);
    }
    if (!meant.goals.empty() && response.goals_canceling.empty()) response.return_code = Response::kErrorRejected;
    responder.answer(response);
    if (!response.goals_canceling.empty()) publishStatus();
  }

  void sendResult(const Id& id, const ResultResponder& responder) {
    forget();
    const auto found = records_.find(id.uuid);
    if (found == records_.end()) return responder.answer({Status::kStatusUnknown, {}});
    Record& record = found->second;
    if (record.isOver) return responder.answer({goals_.status(id), record.result});
    record.waiting.push_back(responder);
    if (record.waiting.size() > kMostWaiting) record.waiting.pop_front();
  }

  void forget() {
    for (const Id& id : goals_.forget(Goals::Clock::now())) records_.erase(id.uuid);
  }

  void publishStatus() { status_->publish(goals_.statuses()); }

  std::function<builtin_interfaces::Time()> now_;
  Handlers handlers_;
  Goals goals_;
  std::map<std::array<std::uint8_t, 16>, Record> records_;
  std::unique_ptr<RosPublisher> feedback_;
  /// Where the action has an older version.
  std::unique_ptr<RosPublisher> olderFeedback_;
  std::unique_ptr<RosPublisher> status_;
  std::unique_ptr<RosServer> sendGoal_;
  std::unique_ptr<RosServer> cancelGoal_;
  std::unique_ptr<RosServer> getResult_;
};

}  // namespace pongsim::ros2
