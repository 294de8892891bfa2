#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pongsim/log.hh"
#include "pongsim/node.hh"
#include "ros2/config/service_rule.hh"
#include "ros2/services/entity_finder.hh"
#include "ros2/services/offers.hh"
#include "ros2/services/requests.hh"
#include "ros2/services/service_names.hh"

namespace pongsim::ros2 {

/// The services of ros_gz_interfaces, which correspond to the simulation's services with the same names: `control`,
/// `create`, `remove` and `set_pose` of the world. As with ros_gz_bridge, the answer is whether it succeeded; a
/// warning, at most one a second for each service, gives the reason for a failure.
class RosGzServices {
 public:
  /// @param rules Other names for some of them.
  /// @param node, finder Must outlive it.
  RosGzServices(RosNode& node, const Node& simulation, const ServiceNames& names, std::span<const ServiceRule> rules,
                const EntityFinder& finder);

  /// Call in each step.
  void preUpdate() { requests_.sweep(); }

 private:
  template <ServiceType Service, class Request>
  void offer(const std::string& target, const std::vector<std::string>& offeredAs,
             std::function<std::optional<std::string>(const typename Service::Request&, Request&)> convert);

  Requests requests_;
  Logger log_;
  Offers offers_;
};

}  // namespace pongsim::ros2
