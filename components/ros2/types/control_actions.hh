#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ros2/types/action_types.hh"
#include "ros2/types/control_msgs.hh"
#include "ros2/types/sensor_msgs.hh"

namespace pongsim::ros2::control_msgs::action {

struct FollowJointTrajectory {
  static constexpr const char* kName = "control_msgs/action/FollowJointTrajectory";
  struct Goal {
    static constexpr const char* kName = "control_msgs/action/FollowJointTrajectory_Goal";
    trajectory_msgs::JointTrajectory trajectory;
    trajectory_msgs::MultiDOFJointTrajectory multi_dof_trajectory;
    std::vector<JointTolerance> path_tolerance;
    std::vector<JointComponentTolerance> component_path_tolerance;
    std::vector<JointTolerance> goal_tolerance;
    std::vector<JointComponentTolerance> component_goal_tolerance;
    builtin_interfaces::Duration goal_time_tolerance;
    static void visit(auto& self, auto&& field) {
      field("trajectory", self.trajectory);
      field("multi_dof_trajectory", self.multi_dof_trajectory);
      field("path_tolerance", self.path_tolerance);
      field("component_path_tolerance", self.component_path_tolerance);
      field("goal_tolerance", self.goal_tolerance);
      field("component_goal_tolerance", self.component_goal_tolerance);
      field("goal_time_tolerance", self.goal_time_tolerance);
    }
    bool operator==(const Goal&) const = default;
  };
  struct Result {
    static constexpr const char* kName = "control_msgs/action/FollowJointTrajectory_Result";
    static constexpr std::int32_t kSuccessful = 0;
    static constexpr std::int32_t kInvalidGoal = -1;
    static constexpr std::int32_t kInvalidJoints = -2;
    static constexpr std::int32_t kOldHeaderTimestamp = -3;
    static constexpr std::int32_t kPathToleranceViolated = -4;
    static constexpr std::int32_t kGoalToleranceViolated = -5;
    std::int32_t error_code = 0;
    std::string error_string;
    static void visit(auto& self, auto&& field) {
      field("error_code", self.error_code);
      field("error_string", self.error_string);
    }
    bool operator==(const Result&) const = default;
  };
  /// Of Kilted and later.
  struct Feedback {
    static constexpr const char* kName = "control_msgs/action/FollowJointTrajectory_Feedback";
    std_msgs::Header header;
    std::vector<std::string> joint_names;
    trajectory_msgs::JointTrajectoryPoint desired;
    trajectory_msgs::JointTrajectoryPoint actual;
    trajectory_msgs::JointTrajectoryPoint error;
    std::int32_t index = 0;
    std::vector<std::string> multi_dof_joint_names;
    trajectory_msgs::MultiDOFJointTrajectoryPoint multi_dof_desired;
    trajectory_msgs::MultiDOFJointTrajectoryPoint multi_dof_actual;
    trajectory_msgs::MultiDOFJointTrajectoryPoint multi_dof_error;
    std::int32_t multi_dof_index = 0;
    static void visit(auto& self, auto&& field) {
      field("header", self.header);
      field("joint_names", self.joint_names);
      field("desired", self.desired);
      field("actual", self.actual);
      field("error", self.error);
      field("index", self.index);
      field("multi_dof_joint_names", self.multi_dof_joint_names);
      field("multi_dof_desired", self.multi_dof_desired);
      field("multi_dof_actual", self.multi_dof_actual);
      field("multi_dof_error", self.multi_dof_error);
      field("multi_dof_index", self.multi_dof_index);
    }
    bool operator==(const Feedback&) const = default;
  };
  /// Of Humble and Jazzy.
  struct OlderFeedback {
    static constexpr const char* kName = "control_msgs/action/FollowJointTrajectory_Feedback";
    std_msgs::Header header;
    std::vector<std::string> joint_names;
    trajectory_msgs::JointTrajectoryPoint desired;
    trajectory_msgs::JointTrajectoryPoint actual;
    trajectory_msgs::JointTrajectoryPoint error;
    std::vector<std::string> multi_dof_joint_names;
    trajectory_msgs::MultiDOFJointTrajectoryPoint multi_dof_desired;
    trajectory_msgs::MultiDOFJointTrajectoryPoint multi_dof_actual;
    trajectory_msgs::MultiDOFJointTrajectoryPoint multi_dof_error;
    static void visit(auto& self, auto&& field) {
      field("header", self.header);
      field("joint_names", self.joint_names);
      field("desired", self.desired);
      field("actual", self.actual);
      field("error", self.error);
      field("multi_dof_joint_names", self.multi_dof_joint_names);
      field("multi_dof_desired", self.multi_dof_desired);
      field("multi_dof_actual", self.multi_dof_actual);
      field("multi_dof_error", self.multi_dof_error);
    }
    bool operator==(const OlderFeedback&) const = default;
  };
  static OlderFeedback toOlder(const Feedback& feedback) {
    return {
        feedback.header,         feedback.joint_names,           feedback.desired,           feedback.actual,
        feedback.error,          feedback.multi_dof_joint_names, feedback.multi_dof_desired, feedback.multi_dof_actual,
        feedback.multi_dof_error};
  }
};

struct GripperCommand {
  static constexpr const char* kName = "control_msgs/action/GripperCommand";
  struct Goal {
    static constexpr const char* kName = "control_msgs/action/GripperCommand_Goal";
    control_msgs::GripperCommand command;
    static void visit(auto& self, auto&& field) { field("command", self.command); }
    bool operator==(const Goal&) const = default;
  };
  struct Result {
    static constexpr const char* kName = "control_msgs/action/GripperCommand_Result";
    double position = 0;
    double effort = 0;
    bool stalled = false;
    bool reached_goal = false;
    static void visit(auto& self, auto&& field) {
      field("position", self.position);
      field("effort", self.effort);
      field("stalled", self.stalled);
      field("reached_goal", self.reached_goal);
    }
    bool operator==(const Result&) const = default;
  };
  struct Feedback {
    static constexpr const char* kName = "control_msgs/action/GripperCommand_Feedback";
    double position = 0;
    double effort = 0;
    bool stalled = false;
    bool reached_goal = false;
    static void visit(auto& self, auto&& field) {
      field("position", self.position);
      field("effort", self.effort);
      field("stalled", self.stalled);
      field("reached_goal", self.reached_goal);
    }
    bool operator==(const Feedback&) const = default;
  };
};

struct ParallelGripperCommand {
  static constexpr const char* kName = "control_msgs/action/ParallelGripperCommand";
  struct Goal {
    static constexpr const char* kName = "control_msgs/action/ParallelGripperCommand_Goal";
    sensor_msgs::JointState command;
    static void visit(auto& self, auto&& field) { field("command", self.command); }
    bool operator==(const Goal&) const = default;
  };
  struct Result {
    static constexpr const char* kName = "control_msgs/action/ParallelGripperCommand_Result";
    sensor_msgs::JointState state;
    bool stalled = false;
    bool reached_goal = false;
    static void visit(auto& self, auto&& field) {
      field("state", self.state);
      field("stalled", self.stalled);
      field("reached_goal", self.reached_goal);
    }
    bool operator==(const Result&) const = default;
  };
  struct Feedback {
    static constexpr const char* kName = "control_msgs/action/ParallelGripperCommand_Feedback";
    sensor_msgs::JointState state;
    static void visit(auto& self, auto&& field) { field("state", self.state); }
    bool operator==(const Feedback&) const = default;
  };
};

}  // namespace pongsim::ros2::control_msgs::action
