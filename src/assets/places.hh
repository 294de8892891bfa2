#pragma once

#include <filesystem>
#include <vector>

namespace pongsim::assets {

/// Where to look for the files that other files refer to.
struct Places {
  /// Folders that contain models and worlds, in search order.
  std::vector<std::filesystem::path> folders;
  /// The local cache of Fuel models: HOST/OWNER/models/NAME/VERSION. Empty: none.
  std::filesystem::path fuelCache;
  /// Folders with what is installed for ROS. They are not searched, but models from outside may read what is in them.
  std::vector<std::filesystem::path> installed = {};

  /// Reads PONGSIM_RESOURCE_PATH, SDF_PATH, IGN_GAZEBO_RESOURCE_PATH, GZ_SIM_RESOURCE_PATH, IGN_FILE_PATH and
  /// GZ_FILE_PATH in this order, each a list of folders separated by ":"; the Fuel cache (`fuelCacheFolder`); and
  /// AMENT_PREFIX_PATH, whose folders have what is installed in `share`.
  static Places fromEnvironment();
};

}  // namespace pongsim::assets
