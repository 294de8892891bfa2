#pragma once

#include <string>

#include "pongsim/system.hh"
#include "ros2/node/node.hh"
#include "ros2/services/entity_services.hh"
#include "ros2/services/ros_gz_services.hh"
#include "ros2/services/run_services.hh"
#include "ros2/services/service_names.hh"

namespace pongsim::ros2 {

/// All services by which nodes of ROS command the simulation. A request is met in the `preUpdate` in which
/// `RosNode::mailbox` is dispatched, as messages are: what comes from outside is in no run's seed, all that follows
/// from it is.
class Services {
 public:
  /// @param prefix As `ServiceNames` has it.
  /// @param node, context Must outlive it.
  Services(RosNode& node, const SystemContext& context, const std::string& prefix, const Frames& frames)
      : names_(prefix, context.world.name()),
        entities_(node, context, names_, frames),
        run_(node, context, names_, entities_.spawner()),
        rosGz_(node, context.node, names_, entities_.finder()) {}

  /// As the system's; `preUpdate` before the mailbox is dispatched.
  void preUpdate(const StepInfo& info) {
    entities_.preUpdate(info);
    run_.preUpdate(info);
    rosGz_.preUpdate();
  }
  void postUpdate(const StepInfo& info) { entities_.postUpdate(info); }
  void worldChanged() { entities_.worldChanged(); }
  void reset() {
    entities_.worldReset();
    run_.worldReset();
  }

 private:
  ServiceNames names_;
  EntityServices entities_;
  RunServices run_;
  RosGzServices rosGz_;
};

}  // namespace pongsim::ros2
