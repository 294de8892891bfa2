#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "ros2/control/hardware_component.hh"
#include "ros2/controllers/controller_manager.hh"
#include "ros2/node/service.hh"
#include "ros2/types/controller_manager_services.hh"

namespace pongsim::ros2 {

/// Offers the services of ros2_control's controller_manager, by which spawners and `ros2 control` use it, and tells on
/// `~/activity` what is active. For the simulation's thread.
class ManagerServices {
 public:
  /// @param manager Must outlive it.
  ManagerServices(ControllerManager& manager, std::vector<HardwareComponent> components, const Logger& log);
  ManagerServices(const ManagerServices&) = delete;
  ManagerServices& operator=(const ManagerServices&) = delete;

  /// Call it between two steps: publishes changes.
  void update();

 private:
  controller_manager_msgs::srv::ListControllers::Response listControllers() const;
  controller_manager_msgs::srv::ListControllerTypes::Response listTypes() const;
  controller_manager_msgs::srv::ListHardwareComponents::Response listComponents() const;
  controller_manager_msgs::srv::ListHardwareInterfaces::Response listInterfaces() const;
  controller_manager_msgs::srv::SwitchController::Response switchTo(
      const controller_manager_msgs::srv::SwitchController::Request& request);
  controller_manager_msgs::srv::SetHardwareComponentState::Response setComponentState(
      const controller_manager_msgs::srv::SetHardwareComponentState::Request& request) const;
  bool tell(const Outcome<void>& outcome) const;
  void publishActivity() const;

  ControllerManager& manager_;
  std::vector<HardwareComponent> components_;
  const Logger& log_;
  std::uint64_t told_ = 0;
  std::unique_ptr<RosPublisher> activity_;
  std::vector<std::unique_ptr<RosServer>> servers_;
};

}  // namespace pongsim::ros2
