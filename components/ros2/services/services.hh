#pragma once

#include <string>

#include "pongsim/system.hh"
#include "ros2/config/settings.hh"
#include "ros2/node/node.hh"
#include "ros2/services/entity_services.hh"
#include "ros2/services/ros_gz_services.hh"
#include "ros2/services/run_services.hh"
#include "ros2/services/service_names.hh"
#include "ros2/services/simulate_steps.hh"

namespace pongsim::ros2 {

/// All services with which ROS nodes command the simulation. Requests are handled in the `preUpdate` that dispatches
/// `RosNode::mailbox`, like messages: external input is not determined by a run's seed, but everything that follows
/// from it is.
class Services {
 public:
  /// @param prefix See `ServiceNames`.
  /// @param node, context Must outlive it.
  Services(RosNode& node, const SystemContext& context, const std::string& prefix, const Settings& settings)
      : names_(prefix, context.world.name()),
        entities_(node, context, names_, settings.frames),
        run_(node, context, names_, entities_.spawner(), [this] { return steps_.isRunning(); }),
        steps_(context.node, names_.inSimulation("control"), node, names_.ofSimulator("simulate_steps")),
        rosGz_(node, context.node, names_, settings.services, entities_.finder()) {}

  /// Call like a system's functions; `preUpdate` before the mailbox is dispatched.
  void preUpdate(const StepInfo& info) {
    entities_.preUpdate(info);
    run_.preUpdate(info);
    steps_.preUpdate(info);
    rosGz_.preUpdate();
  }
  void postUpdate(const StepInfo& info) {
    entities_.postUpdate(info);
    steps_.postUpdate(info);
  }
  void worldChanged() { entities_.worldChanged(); }
  void reset() {
    entities_.worldReset();
    run_.worldReset();
    steps_.reset();
  }

 private:
  ServiceNames names_;
  EntityServices entities_;
  RunServices run_;
  SimulateSteps steps_;
  RosGzServices rosGz_;
};

}  // namespace pongsim::ros2
