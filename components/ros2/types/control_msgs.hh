#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ros2/types/geometry_msgs.hh"
#include "ros2/types/std_msgs.hh"
#include "ros2/types/trajectory_msgs.hh"

/// As in Jazzy. Kilted has another name for a field of SteeringControllerStatus, and the same bytes.
namespace pongsim::ros2::control_msgs {

struct InterfaceValue {
  static constexpr const char* kName = "control_msgs/msg/InterfaceValue";
  std::vector<std::string> interface_names;
  std::vector<double> values;
  static void visit(auto& self, auto&& field) {
    field("interface_names", self.interface_names);
    field("values", self.values);
  }
  bool operator==(const InterfaceValue&) const = default;
};

struct DynamicJointState {
  static constexpr const char* kName = "control_msgs/msg/DynamicJointState";
  std_msgs::Header header;
  std::vector<std::string> joint_names;
  std::vector<InterfaceValue> interface_values;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("joint_names", self.joint_names);
    field("interface_values", self.interface_values);
  }
  bool operator==(const DynamicJointState&) const = default;
};

struct SteeringControllerStatus {
  static constexpr const char* kName = "control_msgs/msg/SteeringControllerStatus";
  std_msgs::Header header;
  std::vector<double> traction_wheels_position;
  std::vector<double> traction_wheels_velocity;
  std::vector<double> steer_positions;
  std::vector<double> linear_velocity_command;
  std::vector<double> steering_angle_command;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("traction_wheels_position", self.traction_wheels_position);
    field("traction_wheels_velocity", self.traction_wheels_velocity);
    field("steer_positions", self.steer_positions);
    field("linear_velocity_command", self.linear_velocity_command);
    field("steering_angle_command", self.steering_angle_command);
  }
  bool operator==(const SteeringControllerStatus&) const = default;
};

struct MecanumDriveControllerState {
  static constexpr const char* kName = "control_msgs/msg/MecanumDriveControllerState";
  std_msgs::Header header;
  double front_left_wheel_velocity = 0;
  double back_left_wheel_velocity = 0;
  double back_right_wheel_velocity = 0;
  double front_right_wheel_velocity = 0;
  geometry_msgs::Twist reference_velocity;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("front_left_wheel_velocity", self.front_left_wheel_velocity);
    field("back_left_wheel_velocity", self.back_left_wheel_velocity);
    field("back_right_wheel_velocity", self.back_right_wheel_velocity);
    field("front_right_wheel_velocity", self.front_right_wheel_velocity);
    field("reference_velocity", self.reference_velocity);
  }
  bool operator==(const MecanumDriveControllerState&) const = default;
};

struct JointTolerance {
  static constexpr const char* kName = "control_msgs/msg/JointTolerance";
  std::string name;
  double position = 0;
  double velocity = 0;
  double acceleration = 0;
  static void visit(auto& self, auto&& field) {
    field("name", self.name);
    field("position", self.position);
    field("velocity", self.velocity);
    field("acceleration", self.acceleration);
  }
  bool operator==(const JointTolerance&) const = default;
};

struct JointComponentTolerance {
  static constexpr const char* kName = "control_msgs/msg/JointComponentTolerance";
  std::string joint_name;
  std::uint16_t component = 0;
  double position = 0;
  double velocity = 0;
  double acceleration = 0;
  static void visit(auto& self, auto&& field) {
    field("joint_name", self.joint_name);
    field("component", self.component);
    field("position", self.position);
    field("velocity", self.velocity);
    field("acceleration", self.acceleration);
  }
  bool operator==(const JointComponentTolerance&) const = default;
};

struct GripperCommand {
  static constexpr const char* kName = "control_msgs/msg/GripperCommand";
  double position = 0;
  double max_effort = 0;
  static void visit(auto& self, auto&& field) {
    field("position", self.position);
    field("max_effort", self.max_effort);
  }
  bool operator==(const GripperCommand&) const = default;
};

struct JointTrajectoryControllerState {
  static constexpr const char* kName = "control_msgs/msg/JointTrajectoryControllerState";
  std_msgs::Header header;
  std::vector<std::string> joint_names;
  trajectory_msgs::JointTrajectoryPoint reference;
  trajectory_msgs::JointTrajectoryPoint feedback;
  trajectory_msgs::JointTrajectoryPoint error;
  trajectory_msgs::JointTrajectoryPoint output;
  std::vector<std::string> multi_dof_joint_names;
  trajectory_msgs::MultiDOFJointTrajectoryPoint multi_dof_reference;
  trajectory_msgs::MultiDOFJointTrajectoryPoint multi_dof_feedback;
  trajectory_msgs::MultiDOFJointTrajectoryPoint multi_dof_error;
  trajectory_msgs::MultiDOFJointTrajectoryPoint multi_dof_output;
  double speed_scaling_factor = 0;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("joint_names", self.joint_names);
    field("reference", self.reference);
    field("feedback", self.feedback);
    field("error", self.error);
    field("output", self.output);
    field("multi_dof_joint_names", self.multi_dof_joint_names);
    field("multi_dof_reference", self.multi_dof_reference);
    field("multi_dof_feedback", self.multi_dof_feedback);
    field("multi_dof_error", self.multi_dof_error);
    field("multi_dof_output", self.multi_dof_output);
    field("speed_scaling_factor", self.speed_scaling_factor);
  }
  bool operator==(const JointTrajectoryControllerState&) const = default;
};

}  // namespace pongsim::ros2::control_msgs
