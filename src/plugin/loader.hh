#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "description/plugin.hh"
#include "plugin/core_systems.hh"
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

  /// Whether a plugin that can't be had is left out with a warning, as in Fortress, or is an error.
  enum class Need { kOptional, kRequired };

  /// @return A new system, not configured yet; null, with a diagnostic now or from `reportMissing`, if there is none.
  std::unique_ptr<System> load(const description::Plugin& plugin, Paths paths, Need need, Diagnostics& diagnostics);

  /// Warns of the plugins that were left out since the last call and are like nothing known: one warning for those of
  /// Gazebo Classic and ROS, and one for the others, however many there are.
  void reportMissing(Diagnostics& diagnostics);

  /// Warns of a system of pongsim itself that has no effect, of each once.
  void reportLimit(const CoreSystem& system, const SourcePosition& position, Diagnostics& diagnostics);

 private:
  const Library* library(const std::string& name, const description::Plugin& plugin, Paths paths, Need need,
                         Diagnostics& diagnostics);
  void noteNotFound(const std::string& name, const description::Plugin& plugin, Need need, Diagnostics& diagnostics);
  std::string lookedIn() const;

  std::vector<std::filesystem::path> searchPath_;
  /// Keyed by short name.
  std::map<std::string, std::unique_ptr<Library>> libraries_;
  /// Short names of the plugins that were left out; each is reported once.
  std::vector<std::string> missed_;
  /// Names of the systems whose limits were said.
  std::set<std::string> limited_;
  /// Those not reported yet.
  std::vector<description::Plugin> foreign_, unknown_;
};

}  // namespace pongsim::plugin
