#pragma once

#include <string>

#include "pongsim/handles.hh"
#include "pongsim/types.hh"
#include "ros2/bridge/bridge.hh"
#include "ros2/config/settings.hh"
#include "ros2/node/node.hh"
#include "ros2/node/parameters.hh"

namespace pongsim::ros2 {

/// The parameters of the simulation's node: settings that can be changed at run time, and, read-only, those it was
/// started with.
class SimulationParameters {
 public:
  /// @param settings Those that the bridge was created with.
  SimulationParameters(RosNode& node, const World& world, Bridge& bridge, const Settings& settings);

  /// Call in each step before the mailbox is dispatched, with the simulated time.
  void preUpdate(Time time);

  /// For adding further parameters.
  Parameters& parameters() { return parameters_; }

 private:
  void declareSwitches(Bridge& bridge, const Settings& settings);
  void declareReadOnly(const Settings& settings);
  void declareQuality(const Settings& settings);
  void addReadOnly(const std::string& name, const char* description, const Parameters::Value& value);

  World world_;
  Time time_{0};
  double realTimeFactor_;
  Parameters parameters_;
};

}  // namespace pongsim::ros2
