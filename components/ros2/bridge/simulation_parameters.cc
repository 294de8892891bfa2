#include "ros2/bridge/simulation_parameters.hh"

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ros2/node/stamp.hh"

namespace pongsim::ros2 {

namespace {

constexpr const char* kRealTimeFactor = "real_time_factor";

}  // namespace

SimulationParameters::SimulationParameters(RosNode& node, const World& world, Bridge& bridge, const Settings& settings)
    : world_(world), realTimeFactor_(world.realTimeFactor()), parameters_(node, [this] { return stampOf(time_); }) {
  Parameters::Descriptor descriptor;
  descriptor.name = kRealTimeFactor;
  descriptor.description =
      "target real-time factor of the world; 0: as fast as possible. No effect in a run with a fixed step rate (-z).";
  descriptor.floating_point_range =
      std::vector{rcl_interfaces::FloatingPointRange{0, std::numeric_limits<double>::max(), 0}};
  parameters_.declare(descriptor, parameterOf(realTimeFactor_), [this](const Parameters::Value& value) {
    const Outcome<void> set = world_.setRealTimeFactor(value.double_value);
    if (set) realTimeFactor_ = value.double_value;
    return set ? std::nullopt : std::optional(set.error);
  });
  declareSwitches(bridge, settings);
  declareReadOnly(settings);
  declareQuality(settings);
}

void SimulationParameters::declareSwitches(Bridge& bridge, const Settings& settings) {
  Parameters::Descriptor descriptor;
  descriptor.name = "bridge_all";
  descriptor.description = "whether to bridge all topics that have a ROS type, or only those that are named";
  parameters_.declare(descriptor, parameterOf(settings.bridgesAll), [&bridge](const Parameters::Value& value) {
    bridge.setBridgesAll(value.bool_value);
    return std::nullopt;
  });
  descriptor.name = "override_timestamps_with_wall_time";
  descriptor.description = "whether messages to ROS are stamped with wall time instead of simulated time";
  parameters_.declare(descriptor, parameterOf(settings.frames.usesWallTime), [&bridge](const Parameters::Value& value) {
    bridge.setWallTime(value.bool_value);
    return std::nullopt;
  });
}

void SimulationParameters::addReadOnly(const std::string& name, const char* description,
                                       const Parameters::Value& value) {
  if (!parameters_.get({name}).empty()) return;
  Parameters::Descriptor descriptor;
  descriptor.name = name;
  descriptor.description = description;
  parameters_.declare(descriptor, value);
}

void SimulationParameters::declareReadOnly(const Settings& settings) {
  addReadOnly("use_sim_time", "always true: this node uses the simulated time that it publishes on /clock",
              parameterOf(true));
  addReadOnly("domain", "number of the domain", parameterOf(static_cast<std::int64_t>(settings.participant.domain)));
  addReadOnly("distro", "distribution of the other nodes, as given at the start; empty: not given",
              parameterOf(settings.distro));
  addReadOnly("localhost_only", "whether the node keeps to this machine and announces 127.0.0.1",
              parameterOf(settings.participant.isLoopbackOnly));
  addReadOnly("network", "network interface for nodes on other machines; empty: none",
              parameterOf(settings.participant.interface.value_or("")));
  addReadOnly("namespace", "prefix of the node's and topics' names", parameterOf(settings.nameSpace));
  addReadOnly("frame_prefix", "prefix of all frames", parameterOf(settings.frames.prefix));
  addReadOnly("config_file", "configuration file of the bridge; empty: none", parameterOf(settings.configFile));
}

/// Named as in rclcpp: those of the events, which rclcpp's nodes have too, and those of rules.
void SimulationParameters::declareQuality(const Settings& settings) {
  constexpr const char* kDescription = "quality of service";
  addReadOnly("qos_overrides./parameter_events.publisher.depth", kDescription, parameterOf(std::int64_t{1000}));
  for (const auto& [policy, value] :
       {std::pair{"durability", "volatile"}, std::pair{"history", "keep_last"}, std::pair{"reliability", "reliable"}}) {
    addReadOnly(std::string("qos_overrides./parameter_events.publisher.") + policy, kDescription,
                parameterOf(std::string(value)));
  }
  for (const TopicRule& rule : settings.rules) {
    if (rule.pair == nullptr) continue;
    for (const bool goesToRos : {true, false}) {
      if (!(goesToRos ? rule.goesToRos() : rule.comesFromRos())) continue;
      const DirectionRule& options = goesToRos ? rule.toRos : rule.fromRos;
      const std::string prefix = "qos_overrides." + rule.ros + (goesToRos ? ".publisher." : ".subscription.");
      if (options.depth)
        addReadOnly(prefix + "depth", kDescription, parameterOf(static_cast<std::int64_t>(*options.depth)));
      if (options.isReliable) {
        addReadOnly(prefix + "reliability", kDescription,
                    parameterOf(std::string(*options.isReliable ? "reliable" : "best_effort")));
      }
      if (options.isTransientLocal) {
        addReadOnly(prefix + "durability", kDescription,
                    parameterOf(std::string(*options.isTransientLocal ? "transient_local" : "volatile")));
      }
    }
  }
}

void SimulationParameters::preUpdate(Time time) {
  time_ = time;
  if (world_.realTimeFactor() == realTimeFactor_) return;
  // changed by a service of the simulation, or by a reset
  realTimeFactor_ = world_.realTimeFactor();
  parameters_.update(kRealTimeFactor, parameterOf(realTimeFactor_));
}

}  // namespace pongsim::ros2
