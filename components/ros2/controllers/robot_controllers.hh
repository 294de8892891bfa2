#pragma once

#include <array>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/system.hh"
#include "ros2/control/hardware_component.hh"
#include "ros2/control/hardware_interfaces.hh"
#include "ros2/control/joint_driver.hh"
#include "ros2/controllers/controller_manager.hh"
#include "ros2/controllers/manager_services.hh"
#include "ros2/controllers/ros_home.hh"

namespace pongsim::ros2 {

/// The controllers of a robot that run inside the simulation: its hardware interfaces, its controller manager and that
/// one's services. For the simulation's thread.
class RobotControllers {
 public:
  struct Options {
    /// "controller_manager"
    std::string name;
    /// "/" or "/robot"
    std::string nameSpace;
    ParameterFiles files;
    Remaps remaps;
    /// [Hz]
    double rate = 100;
  };

  /// @param drivers Must outlive it, like `log`.
  RobotControllers(std::shared_ptr<RosHome> home, const SystemContext& context,
                   const std::vector<JointDriver*>& drivers, std::vector<HardwareComponent> components,
                   const Logger& log, Options options);
  ~RobotControllers();
  RobotControllers(const RobotControllers&) = delete;
  RobotControllers& operator=(const RobotControllers&) = delete;

  const ControllerManager& manager() const { return *manager_; }

  /// Call it between two steps, also while paused.
  void preUpdate();
  /// Call it after each step.
  void postUpdate(Time now) { manager_->update(now); }
  void reset();
  void transfer(StateArchive& archive);

 private:
  /// The last reading of an IMU: orientation (x, y, z, w), angular velocity, linear acceleration.
  struct ImuReading {
    std::array<double, 10> values = {0, 0, 0, 1};
    Subscription subscription;
  };
  void addSensor(const SystemContext& context, const HardwareComponent::Part& part);

  std::shared_ptr<RosHome> home_;
  HardwareInterfaces hardware_;
  std::list<ImuReading> imus_;
  std::optional<ControllerManager> manager_;
  std::optional<ManagerServices> services_;
  std::uint64_t known_ = 0;
};

}  // namespace pongsim::ros2
