#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ros2/config/rule_text.hh"
#include "ros2/config/service_rule.hh"
#include "ros2/config/topic_rule.hh"

namespace pongsim::ros2 {

/// What names that are not in full are meant in.
struct NameScope {
  /// "/" or "/robot"
  std::string nameSpace = "/";
  std::string nodeName = "pongsim";
  /// Whether names of the simulation's topics are expanded as those of ROS: "scan" to "/robot/scan", "~/scan" to
  /// "/robot/pongsim/scan" (`expand_gz_topic_names`).
  bool expandsIgnition = false;
};

struct Rules {
  std::vector<TopicRule> topics;
  std::vector<ServiceRule> services;
};

/// Turns what users say into rules: finds the pairs, completes the names, and joins a topic's two ways where they are
/// said one by one. What can't be, contradicts another rule, or has no effect is added to `diagnostics`.
/// @return The rules with which nothing is wrong, in the order of the texts.
Rules makeRules(std::span<const RuleText> texts, const NameScope& scope, Diagnostics& diagnostics);

/// Warns of services that are not those of the world of that name.
void warnOfOtherWorlds(std::span<const ServiceRule> services, std::string_view world, Diagnostics& diagnostics);

/// @return The type of ROS that is spelt most like `name`, as a hint: "did you mean 'std_msgs/msg/String'?", or empty.
std::string hintOfRosType(std::string_view name);

}  // namespace pongsim::ros2
