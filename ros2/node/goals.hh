#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

#include "ros2/types/action_msgs.hh"

namespace pongsim::ros2 {

/// The goals that an action server has taken, and what became of them: the states of action_msgs/msg/GoalStatus. Those
/// that have ended are kept for a while, for who asks for the result. For one thread.
class Goals {
 public:
  using Id = unique_identifier_msgs::UUID;
  using Time = builtin_interfaces::Time;
  using Status = action_msgs::GoalStatus;
  using Clock = std::chrono::steady_clock;

  /// As rcl_action keeps results, and no more than so many of them.
  static constexpr std::chrono::minutes kKept{15};
  static constexpr std::size_t kMostKept = 1000;

  /// Takes a goal, which executes from now on.
  /// @return Whether it did; not where there is one of that id.
  bool accept(const Id& id, const Time& stamp);

  /// @return One of `Status::kStatus...`; unknown where there is none of that id.
  std::int8_t status(const Id& id) const;
  /// @return When it was accepted; zeros where there is none of that id.
  Time stamp(const Id& id) const;

  /// An executing goal is to be cancelled.
  void startCanceling(const Id& id);
  /// @param status kStatusSucceeded, kStatusCanceled or kStatusAborted.
  void end(const Id& id, std::int8_t status, Clock::time_point now);

  /// Which goals a request to cancel means, as action_msgs/srv/CancelGoal defines it: without id and time all, with an
  /// id that one, with a time those that were accepted then or before; with both, those of either.
  struct ToCancel {
    /// `CancelGoal::Response::kError...`, as far as it is known before anybody was asked.
    std::int8_t code = 0;
    std::vector<action_msgs::GoalInfo> goals;
  };
  ToCancel toCancel(const action_msgs::GoalInfo& asked) const;

  /// Forgets what has ended long ago.
  /// @return Of what it was.
  std::vector<Id> forget(Clock::time_point now);

  /// @return All, in the order in which they came.
  action_msgs::GoalStatusArray statuses() const;

 private:
  struct Goal {
    Status status;
    Clock::time_point ended;
  };
  const Goal* find(const Id& id) const;
  Goal* find(const Id& id);

  std::vector<Goal> goals_;
};

}  // namespace pongsim::ros2
