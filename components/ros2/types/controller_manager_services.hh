#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ros2/types/controller_manager_msgs.hh"

namespace pongsim::ros2::controller_manager_msgs::srv {

struct LoadController {
  static constexpr const char* kName = "controller_manager_msgs/srv/LoadController";
  struct Request {
    static constexpr const char* kName = "controller_manager_msgs/srv/LoadController_Request";
    std::string name;
    static void visit(auto& self, auto&& field) { field("name", self.name); }
    bool operator==(const Request&) const = default;
  };
  struct Response {
    static constexpr const char* kName = "controller_manager_msgs/srv/LoadController_Response";
    bool ok = false;
    static void visit(auto& self, auto&& field) { field("ok", self.ok); }
    bool operator==(const Response&) const = default;
  };
};

struct ConfigureController {
  static constexpr const char* kName = "controller_manager_msgs/srv/ConfigureController";
  struct Request {
    static constexpr const char* kName = "controller_manager_msgs/srv/ConfigureController_Request";
    std::string name;
    static void visit(auto& self, auto&& field) { field("name", self.name); }
    bool operator==(const Request&) const = default;
  };
  struct Response {
    static constexpr const char* kName = "controller_manager_msgs/srv/ConfigureController_Response";
    bool ok = false;
    static void visit(auto& self, auto&& field) { field("ok", self.ok); }
    bool operator==(const Response&) const = default;
  };
};

struct UnloadController {
  static constexpr const char* kName = "controller_manager_msgs/srv/UnloadController";
  struct Request {
    static constexpr const char* kName = "controller_manager_msgs/srv/UnloadController_Request";
    std::string name;
    static void visit(auto& self, auto&& field) { field("name", self.name); }
    bool operator==(const Request&) const = default;
  };
  struct Response {
    static constexpr const char* kName = "controller_manager_msgs/srv/UnloadController_Response";
    bool ok = false;
    static void visit(auto& self, auto&& field) { field("ok", self.ok); }
    bool operator==(const Response&) const = default;
  };
};

struct CleanupController {
  static constexpr const char* kName = "controller_manager_msgs/srv/CleanupController";
  struct Request {
    static constexpr const char* kName = "controller_manager_msgs/srv/CleanupController_Request";
    std::string name;
    static void visit(auto& self, auto&& field) { field("name", self.name); }
    bool operator==(const Request&) const = default;
  };
  struct Response {
    static constexpr const char* kName = "controller_manager_msgs/srv/CleanupController_Response";
    bool ok = false;
    static void visit(auto& self, auto&& field) { field("ok", self.ok); }
    bool operator==(const Response&) const = default;
  };
};

struct ReloadControllerLibraries {
  static constexpr const char* kName = "controller_manager_msgs/srv/ReloadControllerLibraries";
  struct Request {
    static constexpr const char* kName = "controller_manager_msgs/srv/ReloadControllerLibraries_Request";
    bool force_kill = false;
    static void visit(auto& self, auto&& field) { field("force_kill", self.force_kill); }
    bool operator==(const Request&) const = default;
  };
  struct Response {
    static constexpr const char* kName = "controller_manager_msgs/srv/ReloadControllerLibraries_Response";
    bool ok = false;
    static void visit(auto& self, auto&& field) { field("ok", self.ok); }
    bool operator==(const Response&) const = default;
  };
};

struct ListControllerTypes {
  static constexpr const char* kName = "controller_manager_msgs/srv/ListControllerTypes";
  struct Request {
    static constexpr const char* kName = "controller_manager_msgs/srv/ListControllerTypes_Request";
    static void visit(auto&, auto&&) {}
    bool operator==(const Request&) const = default;
  };
  struct Response {
    static constexpr const char* kName = "controller_manager_msgs/srv/ListControllerTypes_Response";
    std::vector<std::string> types;
    std::vector<std::string> base_classes;
    static void visit(auto& self, auto&& field) {
      field("types", self.types);
      field("base_classes", self.base_classes);
    }
    bool operator==(const Response&) const = default;
  };
};

struct SetHardwareComponentState {
  static constexpr const char* kName = "controller_manager_msgs/srv/SetHardwareComponentState";
  struct Request {
    static constexpr const char* kName = "controller_manager_msgs/srv/SetHardwareComponentState_Request";
    std::string name;
    lifecycle_msgs::State target_state;
    static void visit(auto& self, auto&& field) {
      field("name", self.name);
      field("target_state", self.target_state);
    }
    bool operator==(const Request&) const = default;
  };
  struct Response {
    static constexpr const char* kName = "controller_manager_msgs/srv/SetHardwareComponentState_Response";
    bool ok = false;
    lifecycle_msgs::State state;
    static void visit(auto& self, auto&& field) {
      field("ok", self.ok);
      field("state", self.state);
    }
    bool operator==(const Response&) const = default;
  };
};

struct ListControllers {
  static constexpr const char* kName = "controller_manager_msgs/srv/ListControllers";
  struct Request {
    static constexpr const char* kName = "controller_manager_msgs/srv/ListControllers_Request";
    static void visit(auto&, auto&&) {}
    bool operator==(const Request&) const = default;
  };
  struct Response {
    static constexpr const char* kName = "controller_manager_msgs/srv/ListControllers_Response";
    std::vector<ControllerState> controller;
    static void visit(auto& self, auto&& field) { field("controller", self.controller); }
    bool operator==(const Response&) const = default;
  };
  using OlderResponse = controller_manager_msgs_humble::ListControllersResponse;
  static OlderResponse toOlder(const Response& response);
};

struct ListHardwareComponents {
  static constexpr const char* kName = "controller_manager_msgs/srv/ListHardwareComponents";
  struct Request {
    static constexpr const char* kName = "controller_manager_msgs/srv/ListHardwareComponents_Request";
    static void visit(auto&, auto&&) {}
    bool operator==(const Request&) const = default;
  };
  struct Response {
    static constexpr const char* kName = "controller_manager_msgs/srv/ListHardwareComponents_Response";
    std::vector<HardwareComponentState> component;
    static void visit(auto& self, auto&& field) { field("component", self.component); }
    bool operator==(const Response&) const = default;
  };
  using OlderResponse = controller_manager_msgs_humble::ListHardwareComponentsResponse;
  using NewerResponse = controller_manager_msgs_kilted::ListHardwareComponentsResponse;
  static OlderResponse toOlder(const Response& response);
  static NewerResponse toNewer(const Response& response);
};

struct ListHardwareInterfaces {
  static constexpr const char* kName = "controller_manager_msgs/srv/ListHardwareInterfaces";
  struct Request {
    static constexpr const char* kName = "controller_manager_msgs/srv/ListHardwareInterfaces_Request";
    static void visit(auto&, auto&&) {}
    bool operator==(const Request&) const = default;
  };
  struct Response {
    static constexpr const char* kName = "controller_manager_msgs/srv/ListHardwareInterfaces_Response";
    std::vector<HardwareInterface> command_interfaces;
    std::vector<HardwareInterface> state_interfaces;
    static void visit(auto& self, auto&& field) {
      field("command_interfaces", self.command_interfaces);
      field("state_interfaces", self.state_interfaces);
    }
    bool operator==(const Response&) const = default;
  };
  using OlderResponse = controller_manager_msgs_humble::ListHardwareInterfacesResponse;
  static OlderResponse toOlder(const Response& response);
};

struct SwitchController {
  static constexpr const char* kName = "controller_manager_msgs/srv/SwitchController";
  struct Request {
    static constexpr const char* kName = "controller_manager_msgs/srv/SwitchController_Request";
    static constexpr std::int32_t kBestEffort = 1;
    static constexpr std::int32_t kStrict = 2;
    static constexpr std::int32_t kAuto = 3;
    static constexpr std::int32_t kForceAuto = 4;
    std::vector<std::string> activate_controllers;
    std::vector<std::string> deactivate_controllers;
    std::int32_t strictness = 0;
    bool activate_asap = false;
    builtin_interfaces::Duration timeout;
    static void visit(auto& self, auto&& field) {
      field("activate_controllers", self.activate_controllers);
      field("deactivate_controllers", self.deactivate_controllers);
      field("strictness", self.strictness);
      field("activate_asap", self.activate_asap);
      field("timeout", self.timeout);
    }
    bool operator==(const Request&) const = default;
  };
  struct Response {
    static constexpr const char* kName = "controller_manager_msgs/srv/SwitchController_Response";
    bool ok = false;
    std::string message;
    static void visit(auto& self, auto&& field) {
      field("ok", self.ok);
      field("message", self.message);
    }
    bool operator==(const Response&) const = default;
  };
  using OlderRequest = controller_manager_msgs_humble::SwitchControllerRequest;
  using OlderResponse = controller_manager_msgs_humble::SwitchControllerResponse;
  static Request fromOlder(const OlderRequest& older);
  static OlderResponse toOlder(const Response& response) { return {response.ok}; }
};

}  // namespace pongsim::ros2::controller_manager_msgs::srv
