#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "ros2/types/rcl_interfaces.hh"

namespace pongsim::ros2 {

/// Parameters by name, with dots between the names of nested maps: "linear.x.max_velocity".
using ParameterValues = std::map<std::string, rcl_interfaces::ParameterValue>;

/// The content of ROS parameter files in YAML: nodes by name, nested in their namespaces, each with its
/// `ros__parameters`. "*" in a name stands for one part of it, and "**" for any number of them.
class ParameterFiles {
 public:
  /// Reads a file, whose values precede those of files before it.
  /// @return What is wrong with it; empty: nothing.
  std::string read(const std::filesystem::path& file);

  /// @param node "/robot/controller_manager"
  /// @return The parameters of a node, of all entries that fit its name; later ones precede.
  ParameterValues valuesOf(const std::string& node) const;

 private:
  struct Entry {
    /// The parts of the node's name.
    std::vector<std::string> name;
    ParameterValues values;
  };
  std::vector<Entry> entries_;
};

}  // namespace pongsim::ros2
