#pragma once

#include <cstdint>
#include <string>

#include "ros2/types/builtin_interfaces.hh"
#include "ros2/types/reflection.hh"
#include "ros2/types/unique_identifier_msgs.hh"

namespace pongsim::ros2 {

/// A ROS action is a struct with its name and three structs, from which rosidl derives the types on the wire:
///
///     struct SimulateSteps {
///       static constexpr const char* kName = "simulation_interfaces/action/SimulateSteps";
///       struct Goal { static constexpr const char* kName = "simulation_interfaces/action/SimulateSteps_Goal"; ... };
///       struct Result { ... "_Result" ... };
///       struct Feedback { ... "_Feedback" ... };
///     };
///
/// Where an older version of it has other feedback, it has that type, `OlderFeedback`, and a conversion, `toOlder`.
template <class Type>
concept ActionType =
    Structure<typename Type::Goal> && Structure<typename Type::Result> && Structure<typename Type::Feedback>;

template <ActionType Action>
struct SendGoal {
  struct Request {
    static std::string name() { return std::string(Action::kName) + "_SendGoal_Request"; }
    unique_identifier_msgs::UUID goal_id;
    typename Action::Goal goal;
    static void visit(auto& self, auto&& field) {
      field("goal_id", self.goal_id);
      field("goal", self.goal);
    }
    bool operator==(const Request&) const = default;
  };
  struct Response {
    static std::string name() { return std::string(Action::kName) + "_SendGoal_Response"; }
    bool accepted = false;
    builtin_interfaces::Time stamp;
    static void visit(auto& self, auto&& field) {
      field("accepted", self.accepted);
      field("stamp", self.stamp);
    }
    bool operator==(const Response&) const = default;
  };
};

template <ActionType Action>
struct GetResult {
  struct Request {
    static std::string name() { return std::string(Action::kName) + "_GetResult_Request"; }
    unique_identifier_msgs::UUID goal_id;
    static void visit(auto& self, auto&& field) { field("goal_id", self.goal_id); }
    bool operator==(const Request&) const = default;
  };
  struct Response {
    static std::string name() { return std::string(Action::kName) + "_GetResult_Response"; }
    std::int8_t status = 0;
    typename Action::Result result;
    static void visit(auto& self, auto&& field) {
      field("status", self.status);
      field("result", self.result);
    }
    bool operator==(const Response&) const = default;
  };
};

template <ActionType Action, Structure Feedback = typename Action::Feedback>
struct FeedbackMessage {
  static std::string name() { return std::string(Action::kName) + "_FeedbackMessage"; }
  unique_identifier_msgs::UUID goal_id;
  Feedback feedback;
  static void visit(auto& self, auto&& field) {
    field("goal_id", self.goal_id);
    field("feedback", self.feedback);
  }
  bool operator==(const FeedbackMessage&) const = default;
};

}  // namespace pongsim::ros2
