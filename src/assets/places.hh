#pragma once

#include <filesystem>
#include <vector>

namespace pongsim::assets {

/// Where files that others name are looked for.
struct Places {
  /// Folders that hold models and worlds, in the order of the search.
  std::vector<std::filesystem::path> folders;
  /// The local copy of Fuel's models: HOST/OWNER/models/NAME/VERSION. Empty: there is none.
  std::filesystem::path fuelCache;

  /// Reads PONGSIM_RESOURCE_PATH, SDF_PATH, IGN_GAZEBO_RESOURCE_PATH, GZ_SIM_RESOURCE_PATH and IGN_FILE_PATH, folders
  /// with ":" between them, in this order; then IGN_FUEL_CACHE_PATH, in place of HOME/.ignition/fuel.
  static Places fromEnvironment();
};

}  // namespace pongsim::assets
