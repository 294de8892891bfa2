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

/// @return The search path for system libraries: the folders in the environment variables PONGSIM_PLUGIN_PATH,
/// IGN_GAZEBO_SYSTEM_PLUGIN_PATH and GZ_SIM_SYSTEM_PLUGIN_PATH, then the folder of this program's own systems.
std::vector<std::filesystem::path> defaultSearchPath();

/// Creates the systems that `<plugin>` elements ask for, and keeps their libraries loaded: the systems must not outlive
/// it.
class Loader {
 public:
  explicit Loader(std::vector<std::filesystem::path> searchPath = defaultSearchPath());

  /// Whether the filename of a plugin may be a path, which makes whoever writes it run any code on this machine.
  enum class Paths { kAllowed, kNeedLeave, kNever };

  /// @return A new system, not configured yet; null, with a diagnostic, if there is none: a warning for a system of
  /// Fortress that pongsim lacks and for a plugin of Gazebo Classic or ROS, an error for anything else.
  std::unique_ptr<System> load(const description::Plugin& plugin, Paths paths, Diagnostics& diagnostics);

 private:
  const Library* library(const std::string& name, const description::Plugin& plugin, Paths paths,
                         Diagnostics& diagnostics);
  void reportNotFound(const std::string& name, const description::Plugin& plugin, Diagnostics& diagnostics);

  std::vector<std::filesystem::path> searchPath_;
  /// Keyed by short name.
  std::map<std::string, std::unique_ptr<Library>> libraries_;
  /// Missing systems that a warning was given for.
  std::vector<std::string> missed_;
};

}  // namespace pongsim::plugin
