#include "ros2/controllers/manager_services.hh"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ros2/controllers/controller_types.hh"
#include "ros2/node/stamp.hh"

namespace pongsim::ros2 {

namespace {

namespace msgs = controller_manager_msgs;
namespace srv = controller_manager_msgs::srv;
using LifecycleState = lifecycle_msgs::State;

LifecycleState lifecycleOf(ControllerManager::State state) {
  switch (state) {
    case ControllerManager::State::kUnconfigured:
      return {LifecycleState::kPrimaryStateUnconfigured, "unconfigured"};
    case ControllerManager::State::kInactive:
      return {LifecycleState::kPrimaryStateInactive, "inactive"};
    case ControllerManager::State::kActive:
      break;
  }
  return {LifecycleState::kPrimaryStateActive, "active"};
}

/// The simulated hardware is always active.
LifecycleState activeHardware() { return {LifecycleState::kPrimaryStateActive, "active"}; }

std::uint16_t wholeRate(double rate) { return static_cast<std::uint16_t>(std::clamp(std::round(rate), 0.0, 65535.0)); }

msgs::HardwareInterface asMessage(const HardwareInterfaces::Command& command) {
  return {command.name, "double", true, !command.owner.empty()};
}

msgs::HardwareInterface asMessage(const HardwareInterfaces::State& state) {
  return {state.name(), "double", true, false};
}

}  // namespace

ManagerServices::ManagerServices(ControllerManager& manager, std::vector<HardwareComponent> components,
                                 const Logger& log)
    : manager_(manager), components_(std::move(components)), log_(log) {
  RosNode& node = manager.node();
  const RosNode::Quiet quiet(node);
  activity_ = node.advertise<msgs::ControllerManagerActivity>("~/activity", kLatchedQos);
  // one for each service that takes the name of a controller
  const auto serveNamed = [this, &node]<class Service>(const char* name, auto act) {
    servers_.push_back(serveAtOnce<Service>(node, name, [this, act](const typename Service::Request& request) {
      return typename Service::Response{tell((manager_.*act)(request.name))};
    }));
  };
  serveNamed.template operator()<srv::LoadController>("~/load_controller", &ControllerManager::load);
  serveNamed.template operator()<srv::ConfigureController>("~/configure_controller", &ControllerManager::configure);
  serveNamed.template operator()<srv::CleanupController>("~/cleanup_controller", &ControllerManager::cleanUp);
  serveNamed.template operator()<srv::UnloadController>("~/unload_controller", &ControllerManager::unload);
  servers_.push_back(serveAtOnce<srv::ListControllers>(
      node, "~/list_controllers", [this](const srv::ListControllers::Request&) { return listControllers(); }));
  servers_.push_back(serveAtOnce<srv::ListControllerTypes>(
      node, "~/list_controller_types", [this](const srv::ListControllerTypes::Request&) { return listTypes(); }));
  servers_.push_back(serveAtOnce<srv::ListHardwareComponents>(
      node, "~/list_hardware_components",
      [this](const srv::ListHardwareComponents::Request&) { return listComponents(); }));
  servers_.push_back(serveAtOnce<srv::ListHardwareInterfaces>(
      node, "~/list_hardware_interfaces",
      [this](const srv::ListHardwareInterfaces::Request&) { return listInterfaces(); }));
  servers_.push_back(serveAtOnce<srv::SwitchController>(
      node, "~/switch_controller",
      [this](const srv::SwitchController::Request& request) { return switchTo(request); }));
  servers_.push_back(serveAtOnce<srv::SetHardwareComponentState>(
      node, "~/set_hardware_component_state",
      [this](const srv::SetHardwareComponentState::Request& request) { return setComponentState(request); }));
  // nothing to load again
  servers_.push_back(serveAtOnce<srv::ReloadControllerLibraries>(
      node, "~/reload_controller_libraries",
      [](const srv::ReloadControllerLibraries::Request&) { return srv::ReloadControllerLibraries::Response{true}; }));
}

bool ManagerServices::tell(const Outcome<void>& outcome) const {
  if (!outcome) log_.warning(outcome.error);
  return outcome.error.empty();
}

srv::ListControllers::Response ManagerServices::listControllers() const {
  srv::ListControllers::Response response;
  for (const ControllerManager::Loaded& each : manager_.controllers()) {
    msgs::ControllerState& state = response.controller.emplace_back();
    state.name = each.name;
    state.state = lifecycleOf(each.state).label;
    state.type = each.type;
    state.update_rate = wholeRate(each.rate > 0 ? each.rate : manager_.rate());
    state.claimed_interfaces = each.claimed;
    state.required_command_interfaces = each.wanted.commands;
    state.required_state_interfaces = each.wanted.states;
    if (!each.wanted.allStates) continue;
    for (const HardwareInterfaces::State& one : manager_.hardware().states()) {
      state.required_state_interfaces.push_back(one.name());
    }
  }
  return response;
}

srv::ListControllerTypes::Response ManagerServices::listTypes() const {
  srv::ListControllerTypes::Response response;
  for (const ControllerType& type : controllerTypes()) {
    response.types.emplace_back(type.name);
    response.base_classes.emplace_back("controller_interface::ControllerInterface");
  }
  return response;
}

srv::ListHardwareComponents::Response ManagerServices::listComponents() const {
  srv::ListHardwareComponents::Response response;
  for (const HardwareComponent& each : components_) {
    msgs::HardwareComponentState& component = response.component.emplace_back();
    component.name = each.name;
    component.type = each.type;
    component.rw_rate = wholeRate(manager_.rate());
    component.class_type = component.plugin_name = each.plugin;
    component.state = activeHardware();
    const auto isIts = [&each](const std::string& name) {
      const auto has = [&name](const HardwareComponent::Part& part) { return name.starts_with(part.name + "/"); };
      return std::ranges::any_of(each.joints, has) || std::ranges::any_of(each.sensors, has);
    };
    for (const HardwareInterfaces::Command& command : manager_.hardware().commands()) {
      if (isIts(command.name)) component.command_interfaces.push_back(asMessage(command));
    }
    for (const HardwareInterfaces::State& state : manager_.hardware().states()) {
      if (isIts(state.name())) component.state_interfaces.push_back(asMessage(state));
    }
  }
  return response;
}

srv::ListHardwareInterfaces::Response ManagerServices::listInterfaces() const {
  srv::ListHardwareInterfaces::Response response;
  for (const HardwareInterfaces::Command& command : manager_.hardware().commands()) {
    response.command_interfaces.push_back(asMessage(command));
  }
  for (const HardwareInterfaces::State& state : manager_.hardware().states()) {
    response.state_interfaces.push_back(asMessage(state));
  }
  return response;
}

srv::SwitchController::Response ManagerServices::switchTo(const srv::SwitchController::Request& request) {
  const bool isStrict = request.strictness != srv::SwitchController::Request::kBestEffort;
  const Outcome<void> outcome =
      manager_.switchTo(request.activate_controllers, request.deactivate_controllers, isStrict);
  return {tell(outcome), outcome.error};
}

srv::SetHardwareComponentState::Response ManagerServices::setComponentState(
    const srv::SetHardwareComponentState::Request& request) const {
  const bool isKnown = std::ranges::find(components_, request.name, &HardwareComponent::name) != components_.end();
  const LifecycleState& target = request.target_state;
  const bool isActive = target.id == LifecycleState::kPrimaryStateActive || target.label == "active";
  if (!isKnown) return {tell({"there is no hardware component '" + request.name + "'"}), {}};
  const std::string why = "hardware component '" + request.name + "' is simulated and always active";
  return {isActive || tell({why}), activeHardware()};
}

void ManagerServices::update() {
  if (told_ == manager_.version()) return;
  told_ = manager_.version();
  publishActivity();
}

void ManagerServices::publishActivity() const {
  msgs::ControllerManagerActivity activity;
  activity.header.stamp = stampOf(manager_.now());
  for (const ControllerManager::Loaded& each : manager_.controllers()) {
    activity.controllers.push_back({each.name, lifecycleOf(each.state)});
  }
  for (const HardwareComponent& each : components_)
    activity.hardware_components.push_back({each.name, activeHardware()});
  activity_->publish(activity);
}

}  // namespace pongsim::ros2
