#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "description/plugin.hh"
#include "plugin/library.hh"
#include "pongsim/diagnostic.hh"
#include "pongsim/system.hh"

namespace pongsim::plugin {

/// @return Where system libraries are looked for, first to last: the folders of the environment variables
/// PONGSIM_PLUGIN_PATH, IGN_GAZEBO_SYSTEM_PLUGIN_PATH and GZ_SIM_SYSTEM_PLUGIN_PATH, then the one that came with this
/// program.
std::vector<std::filesystem::path> defaultSearchPath();

/// Makes systems from what `<plugin>` elements ask for, and keeps their libraries in memory: the systems must not
/// outlive it.
class Loader {
 public:
  explicit Loader(std::vector<std::filesystem::path> searchPath = defaultSearchPath());

  /// @return A new system, not configured yet; null where there is none, and then `diagnostics` says why: a warning
  /// for a system of Fortress that pongsim does not have and for a plugin of Gazebo Classic or ROS, an error for
  /// anything else.
  std::unique_ptr<System> load(const description::Plugin& plugin, Diagnostics& diagnostics);

 private:
  const Library* library(const std::string& name, const description::Plugin& plugin, Diagnostics& diagnostics);
  void reportNotFound(const std::string& name, const description::Plugin& plugin, Diagnostics& diagnostics);

  std::vector<std::filesystem::path> searchPath_;
  /// By short name.
  std::map<std::string, std::unique_ptr<Library>> libraries_;
  /// Systems of others that were asked for and warned of.
  std::vector<std::string> missed_;
};

}  // namespace pongsim::plugin
