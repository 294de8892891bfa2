#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pongsim/declaration.hh"
#include "pongsim/element.hh"
#include "ros2/config/settings.hh"

namespace pongsim::ros2 {

/// The parameters of the system, as elements of its `<plugin>` or options of `pongsim run`.
class SettingsElements {
 public:
  /// Binds the parameters to members of this, which must outlive the declaration.
  void declare(Declaration& declaration);

  /// Puts the world's name behind that of the node, unless the world's own `<plugin>` names it: other worlds of the
  /// process are nodes, too.
  void nameAfter(std::string_view world, const Element& plugin);

  /// @param plugin The `<plugin>` element, for positions. A file is named from the folder of the file that it stands
  /// in.
  /// @return The settings that they make with what the environment says; nothing where something is wrong, and
  /// `diagnostics` has the errors.
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
