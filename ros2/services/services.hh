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

/// All services by which nodes of ROS command the simulation. A request is met in the `preUpdate` in which
/// `RosNode::mailbox` is dispatched, as messages are: what comes from outside is in no run's seed, all that follows
/// from it is.
class Services {
 public:
  /// @param prefix As `ServiceNames` has it.
  /// @param node, context Must outlive it.
  Services(RosNode& node, const SystemContext& context, const std::string& prefix, const Settings& settings)
      : names_(prefix, context.world.name()),
        entities_(node, context, names_, settings.frames),
        run_(node, context, names_, entities_.spawner(), [this] { return steps_.isRunning(); }),
        steps_(context.node, names_.inSimulation("control"), node, names_.ofSimulator("simulate_steps")),
        rosGz_(node, context.node, names_, settings.services, entities_.finder()) {}

  /// As the system's; `preUpdate` before the mailbox is dispatched.
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
