#pragma once

#include <string>
#include <string_view>

namespace pongsim::ros2 {

/// The names under which services are offered.
class ServiceNames {
 public:
  /// @param prefix For the services of simulation_interfaces: "~" for the node's own name, "/gzserver", or "/".
  /// @param world Name of the world.
  ServiceNames(std::string prefix, std::string_view world);

  /// @param name "spawn_entity"
  /// @return "~/spawn_entity", for `RosNode::resolve`.
  std::string ofSimulator(std::string_view name) const;

  /// @param name "control"
  /// @return "world/W/control", for `RosNode::resolve`: the name of the simulation's service, with characters that ROS
  /// does not allow replaced by '_'.
  std::string ofWorld(std::string_view name) const;

  /// @return The simulation's name, "/world/W/control".
  std::string inSimulation(std::string_view name) const;

 private:
  std::string prefix_;
  std::string world_;
};

}  // namespace pongsim::ros2
