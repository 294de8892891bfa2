#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ros2/types/builtin_interfaces.hh"
#include "ros2/types/lifecycle_msgs.hh"
#include "ros2/types/std_msgs.hh"

/// As in Jazzy; Humble and Kilted differ below.
namespace pongsim::ros2::controller_manager_msgs {

struct ChainConnection {
  static constexpr const char* kName = "controller_manager_msgs/msg/ChainConnection";
  std::string name;
  std::vector<std::string> reference_interfaces;
  static void visit(auto& self, auto&& field) {
    field("name", self.name);
    field("reference_interfaces", self.reference_interfaces);
  }
  bool operator==(const ChainConnection&) const = default;
};

struct ControllerState {
  static constexpr const char* kName = "controller_manager_msgs/msg/ControllerState";
  std::string name;
  std::string state;
  std::string type;
  bool is_async = false;
  std::uint16_t update_rate = 0;
  std::vector<std::string> claimed_interfaces;
  std::vector<std::string> required_command_interfaces;
  std::vector<std::string> required_state_interfaces;
  bool is_chainable = false;
  bool is_chained = false;
  std::vector<std::string> exported_state_interfaces;
  std::vector<std::string> reference_interfaces;
  std::vector<ChainConnection> chain_connections;
  static void visit(auto& self, auto&& field) {
    field("name", self.name);
    field("state", self.state);
    field("type", self.type);
    field("is_async", self.is_async);
    field("update_rate", self.update_rate);
    field("claimed_interfaces", self.claimed_interfaces);
    field("required_command_interfaces", self.required_command_interfaces);
    field("required_state_interfaces", self.required_state_interfaces);
    field("is_chainable", self.is_chainable);
    field("is_chained", self.is_chained);
    field("exported_state_interfaces", self.exported_state_interfaces);
    field("reference_interfaces", self.reference_interfaces);
    field("chain_connections", self.chain_connections);
  }
  bool operator==(const ControllerState&) const = default;
};

struct HardwareInterface {
  static constexpr const char* kName = "controller_manager_msgs/msg/HardwareInterface";
  std::string name;
  std::string data_type;
  bool is_available = false;
  bool is_claimed = false;
  static void visit(auto& self, auto&& field) {
    field("name", self.name);
    field("data_type", self.data_type);
    field("is_available", self.is_available);
    field("is_claimed", self.is_claimed);
  }
  bool operator==(const HardwareInterface&) const = default;
};

struct HardwareComponentState {
  static constexpr const char* kName = "controller_manager_msgs/msg/HardwareComponentState";
  std::string name;
  std::string type;
  bool is_async = false;
  std::uint16_t rw_rate = 0;
  std::string class_type;
  std::string plugin_name;
  lifecycle_msgs::State state;
  std::vector<HardwareInterface> command_interfaces;
  std::vector<HardwareInterface> state_interfaces;
  static void visit(auto& self, auto&& field) {
    field("name", self.name);
    field("type", self.type);
    field("is_async", self.is_async);
    field("rw_rate", self.rw_rate);
    field("class_type", self.class_type);
    field("plugin_name", self.plugin_name);
    field("state", self.state);
    field("command_interfaces", self.command_interfaces);
    field("state_interfaces", self.state_interfaces);
  }
  bool operator==(const HardwareComponentState&) const = default;
};

struct NamedLifecycleState {
  static constexpr const char* kName = "controller_manager_msgs/msg/NamedLifecycleState";
  std::string name;
  lifecycle_msgs::State state;
  static void visit(auto& self, auto&& field) {
    field("name", self.name);
    field("state", self.state);
  }
  bool operator==(const NamedLifecycleState&) const = default;
};

struct ControllerManagerActivity {
  static constexpr const char* kName = "controller_manager_msgs/msg/ControllerManagerActivity";
  std_msgs::Header header;
  std::vector<NamedLifecycleState> controllers;
  std::vector<NamedLifecycleState> hardware_components;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("controllers", self.controllers);
    field("hardware_components", self.hardware_components);
  }
  bool operator==(const ControllerManagerActivity&) const = default;
};

}  // namespace pongsim::ros2::controller_manager_msgs

/// What differs in Kilted and later. The names of the types are the same.
namespace pongsim::ros2::controller_manager_msgs_kilted {

struct HardwareComponentState {
  static constexpr const char* kName = "controller_manager_msgs/msg/HardwareComponentState";
  std::string name;
  std::string type;
  bool is_async = false;
  std::uint16_t rw_rate = 0;
  std::string plugin_name;
  lifecycle_msgs::State state;
  std::vector<controller_manager_msgs::HardwareInterface> command_interfaces;
  std::vector<controller_manager_msgs::HardwareInterface> state_interfaces;
  static void visit(auto& self, auto&& field) {
    field("name", self.name);
    field("type", self.type);
    field("is_async", self.is_async);
    field("rw_rate", self.rw_rate);
    field("plugin_name", self.plugin_name);
    field("state", self.state);
    field("command_interfaces", self.command_interfaces);
    field("state_interfaces", self.state_interfaces);
  }
  bool operator==(const HardwareComponentState&) const = default;
};

struct ListHardwareComponentsResponse {
  static constexpr const char* kName = "controller_manager_msgs/srv/ListHardwareComponents_Response";
  std::vector<HardwareComponentState> component;
  static void visit(auto& self, auto&& field) { field("component", self.component); }
  bool operator==(const ListHardwareComponentsResponse&) const = default;
};

}  // namespace pongsim::ros2::controller_manager_msgs_kilted

/// What differs in Humble. The names of the types are the same.
namespace pongsim::ros2::controller_manager_msgs_humble {

struct ControllerState {
  static constexpr const char* kName = "controller_manager_msgs/msg/ControllerState";
  std::string name;
  std::string state;
  std::string type;
  std::vector<std::string> claimed_interfaces;
  std::vector<std::string> required_command_interfaces;
  std::vector<std::string> required_state_interfaces;
  bool is_chainable = false;
  bool is_chained = false;
  std::vector<std::string> reference_interfaces;
  std::vector<controller_manager_msgs::ChainConnection> chain_connections;
  static void visit(auto& self, auto&& field) {
    field("name", self.name);
    field("state", self.state);
    field("type", self.type);
    field("claimed_interfaces", self.claimed_interfaces);
    field("required_command_interfaces", self.required_command_interfaces);
    field("required_state_interfaces", self.required_state_interfaces);
    field("is_chainable", self.is_chainable);
    field("is_chained", self.is_chained);
    field("reference_interfaces", self.reference_interfaces);
    field("chain_connections", self.chain_connections);
  }
  bool operator==(const ControllerState&) const = default;
};

struct HardwareInterface {
  static constexpr const char* kName = "controller_manager_msgs/msg/HardwareInterface";
  std::string name;
  bool is_available = false;
  bool is_claimed = false;
  static void visit(auto& self, auto&& field) {
    field("name", self.name);
    field("is_available", self.is_available);
    field("is_claimed", self.is_claimed);
  }
  bool operator==(const HardwareInterface&) const = default;
};

struct HardwareComponentState {
  static constexpr const char* kName = "controller_manager_msgs/msg/HardwareComponentState";
  std::string name;
  std::string type;
  std::string class_type;
  lifecycle_msgs::State state;
  std::vector<HardwareInterface> command_interfaces;
  std::vector<HardwareInterface> state_interfaces;
  static void visit(auto& self, auto&& field) {
    field("name", self.name);
    field("type", self.type);
    field("class_type", self.class_type);
    field("state", self.state);
    field("command_interfaces", self.command_interfaces);
    field("state_interfaces", self.state_interfaces);
  }
  bool operator==(const HardwareComponentState&) const = default;
};

struct ListControllersResponse {
  static constexpr const char* kName = "controller_manager_msgs/srv/ListControllers_Response";
  std::vector<ControllerState> controller;
  static void visit(auto& self, auto&& field) { field("controller", self.controller); }
  bool operator==(const ListControllersResponse&) const = default;
};

struct ListHardwareComponentsResponse {
  static constexpr const char* kName = "controller_manager_msgs/srv/ListHardwareComponents_Response";
  std::vector<HardwareComponentState> component;
  static void visit(auto& self, auto&& field) { field("component", self.component); }
  bool operator==(const ListHardwareComponentsResponse&) const = default;
};

struct ListHardwareInterfacesResponse {
  static constexpr const char* kName = "controller_manager_msgs/srv/ListHardwareInterfaces_Response";
  std::vector<HardwareInterface> command_interfaces;
  std::vector<HardwareInterface> state_interfaces;
  static void visit(auto& self, auto&& field) {
    field("command_interfaces", self.command_interfaces);
    field("state_interfaces", self.state_interfaces);
  }
  bool operator==(const ListHardwareInterfacesResponse&) const = default;
};

struct SwitchControllerRequest {
  static constexpr const char* kName = "controller_manager_msgs/srv/SwitchController_Request";
  std::vector<std::string> activate_controllers;
  std::vector<std::string> deactivate_controllers;
  std::vector<std::string> start_controllers;
  std::vector<std::string> stop_controllers;
  std::int32_t strictness = 0;
  bool start_asap = false;
  bool activate_asap = false;
  builtin_interfaces::Duration timeout;
  static void visit(auto& self, auto&& field) {
    field("activate_controllers", self.activate_controllers);
    field("deactivate_controllers", self.deactivate_controllers);
    field("start_controllers", self.start_controllers);
    field("stop_controllers", self.stop_controllers);
    field("strictness", self.strictness);
    field("start_asap", self.start_asap);
    field("activate_asap", self.activate_asap);
    field("timeout", self.timeout);
  }
  bool operator==(const SwitchControllerRequest&) const = default;
};

struct SwitchControllerResponse {
  static constexpr const char* kName = "controller_manager_msgs/srv/SwitchController_Response";
  bool ok = false;
  static void visit(auto& self, auto&& field) { field("ok", self.ok); }
  bool operator==(const SwitchControllerResponse&) const = default;
};

}  // namespace pongsim::ros2::controller_manager_msgs_humble
