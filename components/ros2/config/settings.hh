#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ros2/config/service_rule.hh"
#include "ros2/config/topic_rule.hh"
#include "ros2/wire/participant.hh"

namespace pongsim::ros2 {

/// All settings of the connection to ROS, from the elements of the `<plugin>`, the options of `pongsim run`, the
/// configuration file, and the environment.
struct Settings {
  ParticipantOptions participant;
  /// Name of the other nodes' distribution; empty: not given.
  std::string distro;
  std::string nodeName = "pongsim";
  /// "/" or "/robot": for the node, and for topics without a rule.
  std::string nameSpace = "/";
  Frames frames;
  /// Whether topics without a rule are bridged under their own names.
  bool bridgesAll = true;
  /// Topics that are bridged in a particular way, or (without a pair) not at all.
  std::vector<TopicRule> rules;
  /// Services of the simulation with another name in ROS.
  std::vector<ServiceRule> services;
  /// The file that the rules came from, as named by the user; empty: none.
  std::string configFile;
};

}  // namespace pongsim::ros2
