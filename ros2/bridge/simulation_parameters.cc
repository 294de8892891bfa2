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
      "simulated seconds a second that the world asks for; 0: as many as possible. A run that was given a rate of "
      "steps "
      "keeps to that.";
  descriptor.floating_point_range =
      std::vector{rcl_interfaces::FloatingPointRange{0, std::numeric_limits<double>::max(), 0}};
  parameters_.declare(descriptor, parameterOf(realTimeFactor_), [this](const Parameters::Value& value) {
    const auto error = world_.setRealTimeFactor(value.double_value);
    if (!error) realTimeFactor_ = value.double_value;
    return error;
  });
  declareSwitches(bridge, settings);
  declareReadOnly(settings);
}

void SimulationParameters::declareSwitches(Bridge& bridge, const Settings& settings) {
  Parameters::Descriptor descriptor;
  descriptor.name = "bridge_all";
  descriptor.description = "whether all topics that have a type in ROS are there, or those only that are named";
  parameters_.declare(descriptor, parameterOf(settings.bridgesAll), [&bridge](const Parameters::Value& value) {
    bridge.setBridgesAll(value.bool_value);
    return std::nullopt;
  });
  descriptor.name = "override_timestamps_with_wall_time";
  descriptor.description =
      "whether messages to ROS are stamped with the time of the wall, in place of the simulation's";
  parameters_.declare(descriptor, parameterOf(settings.frames.usesWallTime), [&bridge](const Parameters::Value& value) {
    bridge.setWallTime(value.bool_value);
    return std::nullopt;
  });
}

void SimulationParameters::declareReadOnly(const Settings& settings) {
  const auto add = [this](const char* name, const char* description, const Parameters::Value& value) {
    Parameters::Descriptor descriptor;
    descriptor.name = name;
    descriptor.description = description;
    parameters_.declare(descriptor, value);
  };
  add("use_sim_time", "always: the clock of this node is the one that it publishes on /clock", parameterOf(true));
  add("domain", "number of the domain", parameterOf(static_cast<std::int64_t>(settings.participant.domain)));
  add("distro", "how it speaks on the wire: as humble (and older) or as jazzy (and later)",
      parameterOf(std::string(settings.participant.distro == Distro::kHumble ? "humble" : "jazzy")));
  add("localhost_only", "whether nodes are met on the loopback interface alone",
      parameterOf(settings.participant.isLoopbackOnly));
  add("network", "interface by which nodes of other machines are met; empty: none are",
      parameterOf(settings.participant.interface.value_or("")));
  add("frame_prefix", "in front of all frames", parameterOf(settings.frames.prefix));
  // as rclcpp's nodes show that of the events
  const std::string events = "qos_overrides./parameter_events.publisher.";
  for (const auto& [policy, value] : {std::pair{"depth", parameterOf(std::int64_t{1000})},
                                      std::pair{"durability", parameterOf(std::string("volatile"))},
                                      std::pair{"history", parameterOf(std::string("keep_last"))},
                                      std::pair{"reliability", parameterOf(std::string("reliable"))}}) {
    add((events + policy).c_str(), "quality of service of /parameter_events", value);
  }
}

void SimulationParameters::preUpdate(Time time) {
  time_ = time;
  if (world_.realTimeFactor() == realTimeFactor_) return;
  // by a service of the simulation, or a reset
  realTimeFactor_ = world_.realTimeFactor();
  parameters_.update(kRealTimeFactor, parameterOf(realTimeFactor_));
}

}  // namespace pongsim::ros2
