#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "ros2/node/node.hh"

namespace pongsim::ros2 {

/// Rules that give topics other names: "/diff_drive_controller/odom:=/odom".
class Remaps {
 public:
  /// Adds a rule, "FROM:=TO" or "NODE:FROM:=TO". Rules for names of nodes, "__ns" and the like, are ignored.
  /// @return Whether it is a rule.
  bool add(const std::string& rule);
  /// Adds the rules among ROS arguments: those after "-r" or "--remap".
  void addArguments(std::span<const std::string> arguments);

  /// @param name As in `RosNode::advertise`.
  /// @return The absolute name of a topic of this node.
  std::string apply(const RosNode& node, const std::string& name) const;

 private:
  struct Rule {
    /// Empty: of all nodes.
    std::string node;
    std::string from;
    std::string to;
  };
  std::vector<Rule> rules_;
};

}  // namespace pongsim::ros2
