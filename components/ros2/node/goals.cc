#include "ros2/node/goals.hh"

#include <algorithm>
#include <tuple>
#include <utility>

namespace pongsim::ros2 {

namespace {

using Status = action_msgs::GoalStatus;
using Cancel = action_msgs::srv::CancelGoal::Response;

bool isOver(const Status& status) { return status.status >= Status::kStatusSucceeded; }
bool isCancelable(const Status& status) {
  return status.status == Status::kStatusAccepted || status.status == Status::kStatusExecuting;
}

bool isNotAfter(const builtin_interfaces::Time& a, const builtin_interfaces::Time& b) {
  return std::tie(a.sec, a.nanosec) <= std::tie(b.sec, b.nanosec);
}

}  // namespace

const Goals::Goal* Goals::find(const Id& id) const {
  const auto found = std::ranges::find(goals_, id, [](const Goal& goal) { return goal.status.goal_info.goal_id; });
  return found == goals_.end() ? nullptr : &*found;
}

Goals::Goal* Goals::find(const Id& id) { return const_cast<Goal*>(std::as_const(*this).find(id)); }

bool Goals::accept(const Id& id, const Time& stamp) {
  if (find(id) != nullptr) return false;
  goals_.push_back({{{id, stamp}, Status::kStatusExecuting}, {}});
  return true;
}

std::int8_t Goals::status(const Id& id) const {
  const Goal* goal = find(id);
  return goal == nullptr ? Status::kStatusUnknown : goal->status.status;
}

Goals::Time Goals::stamp(const Id& id) const {
  const Goal* goal = find(id);
  return goal == nullptr ? Time() : goal->status.goal_info.stamp;
}

void Goals::startCanceling(const Id& id) {
  Goal* goal = find(id);
  if (goal != nullptr && isCancelable(goal->status)) goal->status.status = Status::kStatusCanceling;
}

void Goals::end(const Id& id, std::int8_t status, Clock::time_point now) {
  Goal* goal = find(id);
  if (goal == nullptr || isOver(goal->status)) return;
  goal->status.status = status;
  goal->ended = now;
}

Goals::ToCancel Goals::toCancel(const action_msgs::GoalInfo& request) const {
  const bool hasId = request.goal_id != Id(), hasTime = request.stamp != Time();
  ToCancel result;
  if (hasId && !hasTime) {
    const Goal* goal = find(request.goal_id);
    if (goal == nullptr) return {Cancel::kErrorUnknownGoalId, {}};
    if (!isCancelable(goal->status)) return {Cancel::kErrorGoalTerminated, {}};
    return {Cancel::kErrorNone, {goal->status.goal_info}};
  }
  for (const Goal& goal : goals_) {
    const action_msgs::GoalInfo& info = goal.status.goal_info;
    const bool isMeant = (!hasId && !hasTime) || (hasId && info.goal_id == request.goal_id) ||
                         (hasTime && isNotAfter(info.stamp, request.stamp));
    if (isMeant && isCancelable(goal.status)) result.goals.push_back(info);
  }
  return result;
}

std::vector<Goals::Id> Goals::forget(Clock::time_point now) {
  std::vector<Id> forgotten;
  const auto ended =
      static_cast<std::size_t>(std::ranges::count_if(goals_, [](const Goal& goal) { return isOver(goal.status); }));
  std::size_t tooMany = ended > kMostKept ? ended - kMostKept : 0;
  std::erase_if(goals_, [&](const Goal& goal) {
    if (!isOver(goal.status)) return false;
    const bool goes = tooMany > 0 || now - goal.ended >= kKept;
    if (tooMany > 0) --tooMany;
    if (goes) forgotten.push_back(goal.status.goal_info.goal_id);
    return goes;
  });
  return forgotten;
}

action_msgs::GoalStatusArray Goals::statuses() const {
  action_msgs::GoalStatusArray all;
  for (const Goal& goal : goals_) all.status_list.push_back(goal.status);
  return all;
}

}  // namespace pongsim::ros2
