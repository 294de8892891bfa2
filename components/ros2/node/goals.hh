#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

#include "ros2/types/action_msgs.hh"

namespace pongsim::ros2 {

/// The goals accepted by an action server, and their states from action_msgs/msg/GoalStatus. Finished goals are kept
/// for a while, for clients that ask for the result. For one thread.
class Goals {
 public:
  using Id = unique_identifier_msgs::UUID;
  using Time = builtin_interfaces::Time;
  using Status = action_msgs::GoalStatus;
  using Clock = std::chrono::steady_clock;

  /// How long, and how many of, the results are kept, as in rcl_action.
  static constexpr std::chrono::minutes kKept{15};
  static constexpr std::size_t kMostKept = 1000;

  /// Accepts a goal, which executes from now on.
  /// @return Whether it was accepted; false if a goal with this id exists.
  bool accept(const Id& id, const Time& stamp);

  /// @return One of `Status::kStatus...`; unknown if there is no goal with this id.
  std::int8_t status(const Id& id) const;
  /// @return When it was accepted; zeros if there is no goal with this id.
  Time stamp(const Id& id) const;

  /// Marks an executing goal as being cancelled.
  void startCanceling(const Id& id);
  /// @param status kStatusSucceeded, kStatusCanceled or kStatusAborted.
  void end(const Id& id, std::int8_t status, Clock::time_point now);

  /// The goals that a cancel request selects, as defined by action_msgs/srv/CancelGoal: without id and time, all; with
  /// an id, that goal; with a time, those accepted at or before that time; with both, those that match either.
  struct ToCancel {
    /// `CancelGoal::Response::kError...`, as far as known before the action is asked.
    std::int8_t code = 0;
    std::vector<action_msgs::GoalInfo> goals;
  };
  ToCancel toCancel(const action_msgs::GoalInfo& request) const;

  /// Removes goals that ended long ago.
  /// @return Their ids.
  std::vector<Id> forget(Clock::time_point now);

  /// @return All, in order of arrival.
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
