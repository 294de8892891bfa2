#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pongsim/declaration.hh"
#include "pongsim/element.hh"
#include "ros2/config/settings.hh"

namespace pongsim::ros2 {

/// The system's parameters, as elements of its `<plugin>` or options of `pongsim run`.
class SettingsElements {
 public:
  /// Binds the parameters to members of this, which must outlive the declaration.
  void declare(Declaration& declaration);

  /// Appends the world's name to that of the node, unless the world's own `<plugin>` sets it, because other worlds in
  /// the process are nodes too.
  void nameAfter(std::string_view world, const Element& plugin);

  /// @param plugin The `<plugin>` element, for positions. File paths are relative to the folder of the file that
  /// contains it.
  /// @return The settings, combined with the environment; nothing, with errors in `diagnostics`, if something is wrong.
  std::optional<Settings> read(const Element& plugin, Diagnostics& diagnostics) const;

 private:
  std::optional<ParticipantOptions> readParticipant(const Element& plugin, Diagnostics& diagnostics) const;

  std::optional<double> domain_;
  std::string distro_;
  std::string nodeName_ = "pongsim";
  std::string nameSpace_ = "/";
  std::string framePrefix_;
  std::string configFile_;
  std::vector<std::string> topics_;
  bool bridgesAll_ = true;
  bool expandsIgnition_ = false;
  bool usesWallTime_ = false;
};

}  // namespace pongsim::ros2
