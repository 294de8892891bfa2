#pragma once

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace pongsim::cli {

/// The options of `ign gazebo` that `pongsim run` takes so that scripts run as they are, and that its help does not
/// list: what they ask for is so anyway, or can't be.
class FortressRunOptions {
 public:
  void addTo(CLI::App& run);

  /// @return A sentence on each that is given and changes nothing, where it would in Fortress.
  /// @throws UsageError where one asks for what can't be done without.
  std::vector<std::string> check() const;

 private:
  bool isServer_ = false;
  bool isGui_ = false;
  bool isHeadless_ = false;
  std::optional<std::string> guiConfig_, physicsEngine_, renderEngine_, guiEngine_, serverEngine_, role_, secondaries_;
};

}  // namespace pongsim::cli
