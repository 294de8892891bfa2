#pragma once

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace pongsim::cli {

/// Options of `ign gazebo` and `gz sim` that `pongsim run` accepts so that scripts work unchanged, and that its help
/// does not list: they ask for the default behaviour, or for something that pongsim does not have.
class FortressRunOptions {
 public:
  void addTo(CLI::App& run);

  /// @return One sentence for each given option that has an effect in Gazebo but not here.
  /// @throws UsageError if one asks for something that pongsim does not have and the run depends on.
  std::vector<std::string> check() const;

 private:
  bool isServer_ = false;
  bool isGui_ = false;
  bool isHeadless_ = false;
  // before a run starts, all its models are there anyway
  bool waitsForAssets_ = false;
  std::optional<std::string> guiConfig_, physicsEngine_, renderEngine_, guiEngine_, serverEngine_, role_, secondaries_,
      backend_, guiBackend_, serverBackend_, initialTime_;
};

}  // namespace pongsim::cli
