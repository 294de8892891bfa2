#pragma once

#include <cstdint>
#include <vector>

#include "ros2/types/builtin_interfaces.hh"
#include "ros2/types/unique_identifier_msgs.hh"

namespace pongsim::ros2::action_msgs {

struct GoalInfo {
  static constexpr const char* kName = "action_msgs/msg/GoalInfo";
  unique_identifier_msgs::UUID goal_id;
  builtin_interfaces::Time stamp;
  static void visit(auto& self, auto&& field) {
    field("goal_id", self.goal_id);
    field("stamp", self.stamp);
  }
  bool operator==(const GoalInfo&) const = default;
};

struct GoalStatus {
  static constexpr const char* kName = "action_msgs/msg/GoalStatus";
  static constexpr std::int8_t kStatusUnknown = 0;
  static constexpr std::int8_t kStatusAccepted = 1;
  static constexpr std::int8_t kStatusExecuting = 2;
  static constexpr std::int8_t kStatusCanceling = 3;
  static constexpr std::int8_t kStatusSucceeded = 4;
  static constexpr std::int8_t kStatusCanceled = 5;
  static constexpr std::int8_t kStatusAborted = 6;
  GoalInfo goal_info;
  std::int8_t status = 0;
  static void visit(auto& self, auto&& field) {
    field("goal_info", self.goal_info);
    field("status", self.status);
  }
  bool operator==(const GoalStatus&) const = default;
};

struct GoalStatusArray {
  static constexpr const char* kName = "action_msgs/msg/GoalStatusArray";
  std::vector<GoalStatus> status_list;
  static void visit(auto& self, auto&& field) { field("status_list", self.status_list); }
  bool operator==(const GoalStatusArray&) const = default;
};

namespace srv {

struct CancelGoal {
  static constexpr const char* kName = "action_msgs/srv/CancelGoal";
  struct Request {
    static constexpr const char* kName = "action_msgs/srv/CancelGoal_Request";
    action_msgs::GoalInfo goal_info;
    static void visit(auto& self, auto&& field) { field("goal_info", self.goal_info); }
    bool operator==(const Request&) const = default;
  };

  struct Response {
    static constexpr const char* kName = "action_msgs/srv/CancelGoal_Response";
    static constexpr std::int8_t kErrorNone = 0;
    static constexpr std::int8_t kErrorRejected = 1;
    static constexpr std::int8_t kErrorUnknownGoalId = 2;
    static constexpr std::int8_t kErrorGoalTerminated = 3;
    std::int8_t return_code = 0;
    std::vector<action_msgs::GoalInfo> goals_canceling;
    static void visit(auto& self, auto&& field) {
      field("return_code", self.return_code);
      field("goals_canceling", self.goals_canceling);
    }
    bool operator==(const Response&) const = default;
  };
};

}  // namespace srv

}  // namespace pongsim::ros2::action_msgs
