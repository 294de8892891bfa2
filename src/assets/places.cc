#include "assets/places.hh"

#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "pongsim/files/fuel_address.hh"
#include "pongsim/program/gazebo_variable.hh"

namespace pongsim::assets {

namespace {

// Gazebo appends its resource paths to SDF_PATH, for includes, and to IGN_FILE_PATH, for meshes and textures.
constexpr const char* kVariables[] = {"PONGSIM_RESOURCE_PATH",        "SDF_PATH",
                                      gazebo::kResourcePath.fortress, gazebo::kResourcePath.later,
                                      gazebo::kFilePath.fortress,     gazebo::kFilePath.later};

std::string_view variable(const char* name) {
  const char* const value = std::getenv(name);
  return value != nullptr ? value : "";
}

void addFolders(const char* name, std::vector<std::filesystem::path>& folders) {
  std::string_view rest = variable(name);
  while (!rest.empty()) {
    const std::string_view folder = rest.substr(0, rest.find(':'));
    if (!folder.empty()) folders.emplace_back(folder);
    rest.remove_prefix(std::min(folder.size() + 1, rest.size()));
  }
}

}  // namespace

Places Places::fromEnvironment() {
  Places places;
  for (const char* name : kVariables) addFolders(name, places.folders);
  addFolders("AMENT_PREFIX_PATH", places.installed);
  for (std::filesystem::path& prefix : places.installed) prefix /= "share";
  places.fuelCache = fuelCacheFolder();
  return places;
}

}  // namespace pongsim::assets
