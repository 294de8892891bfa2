#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ros2/config/service_rule.hh"
#include "ros2/config/topic_rule.hh"
#include "ros2/wire/participant.hh"

namespace pongsim::ros2 {

/// All that can be said of how a simulation talks to ROS: from the elements of the `<plugin>`, the options of `pongsim
/// run`, the file, the environment.
struct Settings {
  ParticipantOptions participant;
  std::string nodeName = "pongsim";
  /// "/" or "/robot": of the node, and of the topics without a rule.
  std::string nameSpace = "/";
  Frames frames;
  /// Whether topics without a rule are bridged under their own names.
  bool bridgesAll = true;
  /// Topics that are bridged in a way of their own, or (without a pair) not at all.
  std::vector<TopicRule> rules;
  /// Services of the simulation that have another name in ROS.
  std::vector<ServiceRule> services;
  /// The file that rules came from, as it was named; empty: none.
  std::string configFile;
};

}  // namespace pongsim::ros2
