#pragma once

#include <string>

#include "pongsim/handles.hh"
#include "pongsim/types.hh"
#include "ros2/bridge/bridge.hh"
#include "ros2/config/settings.hh"
#include "ros2/node/node.hh"
#include "ros2/node/parameters.hh"

namespace pongsim::ros2 {

/// The parameters of the simulation's node: what may be changed while it runs, and, read-only, what it was started
/// with.
class SimulationParameters {
 public:
  /// @param settings As the bridge was made with.
  SimulationParameters(RosNode& node, const World& world, Bridge& bridge, const Settings& settings);

  /// To be called in each step before the mailbox is dispatched, with the simulated time.
  void preUpdate(Time time);

  /// For who has parameters of his own.
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
