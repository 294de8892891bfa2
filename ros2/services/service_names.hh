#pragma once

#include <string>
#include <string_view>

namespace pongsim::ros2 {

/// Under which names services are offered.
class ServiceNames {
 public:
  /// @param prefix In front of the services of simulation_interfaces: "~" for the node's own name, "/gzserver", or "/".
  /// @param world Name of the world.
  ServiceNames(std::string prefix, std::string_view world);

  /// @param name "spawn_entity"
  /// @return "~/spawn_entity", for `RosNode::resolve`.
  std::string ofSimulator(std::string_view name) const;

  /// @param name "control"
  /// @return "world/W/control", for `RosNode::resolve`: as the service of the simulation, with what ROS does not allow
  /// in a name made '_'.
  std::string ofWorld(std::string_view name) const;

  /// @return "/world/W/control", as the simulation has it.
  std::string inSimulation(std::string_view name) const;

 private:
  std::string prefix_;
  std::string world_;
};

}  // namespace pongsim::ros2
