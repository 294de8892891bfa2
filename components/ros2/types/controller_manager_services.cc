#include "ros2/types/controller_manager_services.hh"

namespace pongsim::ros2::controller_manager_msgs::srv {

namespace {

namespace humble = controller_manager_msgs_humble;

std::vector<humble::HardwareInterface> olderInterfaces(const std::vector<HardwareInterface>& interfaces) {
  std::vector<humble::HardwareInterface> older;
  for (const HardwareInterface& each : interfaces) older.push_back({each.name, each.is_available, each.is_claimed});
  return older;
}

}  // namespace

ListControllers::OlderResponse ListControllers::toOlder(const Response& response) {
  OlderResponse older;
  for (const ControllerState& each : response.controller) {
    older.controller.push_back({each.name, each.state, each.type, each.claimed_interfaces,
                                each.required_command_interfaces, each.required_state_interfaces, each.is_chainable,
                                each.is_chained, each.reference_interfaces, each.chain_connections});
  }
  return older;
}

ListHardwareComponents::OlderResponse ListHardwareComponents::toOlder(const Response& response) {
  OlderResponse older;
  for (const HardwareComponentState& each : response.component) {
    older.component.push_back({each.name, each.type, each.plugin_name, each.state,
                               olderInterfaces(each.command_interfaces), olderInterfaces(each.state_interfaces)});
  }
  return older;
}

ListHardwareComponents::NewerResponse ListHardwareComponents::toNewer(const Response& response) {
  NewerResponse newer;
  for (const HardwareComponentState& each : response.component) {
    newer.component.push_back({each.name, each.type, each.is_async, each.rw_rate, each.plugin_name, each.state,
                               each.command_interfaces, each.state_interfaces});
  }
  return newer;
}

ListHardwareInterfaces::OlderResponse ListHardwareInterfaces::toOlder(const Response& response) {
  return {olderInterfaces(response.command_interfaces), olderInterfaces(response.state_interfaces)};
}

SwitchController::Request SwitchController::fromOlder(const OlderRequest& older) {
  Request request{older.activate_controllers, older.deactivate_controllers, older.strictness,
                  older.activate_asap || older.start_asap, older.timeout};
  // its deprecated names
  for (const std::string& each : older.start_controllers) request.activate_controllers.push_back(each);
  for (const std::string& each : older.stop_controllers) request.deactivate_controllers.push_back(each);
  return request;
}

}  // namespace pongsim::ros2::controller_manager_msgs::srv
