#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ros2/config/rule_text.hh"
#include "ros2/config/service_rule.hh"
#include "ros2/config/topic_rule.hh"

namespace pongsim::ros2 {

/// How to resolve relative names.
struct NameScope {
  /// "/" or "/robot"
  std::string nameSpace = "/";
  std::string nodeName = "pongsim";
  /// Whether names of the simulation's topics are expanded like ROS names: "scan" to "/robot/scan", "~/scan" to
  /// "/robot/pongsim/scan" (`expand_gz_topic_names`).
  bool expandsIgnition = false;
};

struct Rules {
  std::vector<TopicRule> topics;
  std::vector<ServiceRule> services;
};

/// Converts the users' texts to rules: finds the pairs, resolves the names, and merges the two directions of a topic if
/// they are given separately. What is invalid, contradicts another rule, or has no effect is added to `diagnostics`.
/// @return The valid rules, in the order of the texts.
Rules makeRules(std::span<const RuleText> texts, const NameScope& scope, Diagnostics& diagnostics);

/// Warns about services that do not belong to the world with this name.
void warnOfOtherWorlds(std::span<const ServiceRule> services, std::string_view world, Diagnostics& diagnostics);

/// @return A hint with the most similar ROS type: "did you mean 'std_msgs/msg/String'?", or empty.
std::string hintOfRosType(std::string_view name);

}  // namespace pongsim::ros2
