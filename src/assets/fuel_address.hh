#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace pongsim::assets {

/// A model on a Fuel server: "https://fuel.gazebosim.org/1.0/OpenRobotics/models/Coke/2".
struct FuelAddress {
  std::string host;
  std::string owner;
  std::string model;
  /// Nothing: the newest.
  std::optional<int> version;
  /// A file of the model ("meshes/coke.dae"), or empty.
  std::filesystem::path file;
};

/// @return Whether the text is the address of a Fuel server, well-formed or not.
bool isFuelAddress(std::string_view uri);

/// @return Nothing where the text is not a model's address.
std::optional<FuelAddress> parseFuelAddress(std::string_view uri);

/// @param host Which server's part of the cache.
/// @return Where a cache keeps the versions of the model: names in lower case, as Fortress writes them.
std::filesystem::path cacheFolder(const FuelAddress& address, std::string_view host,
                                  const std::filesystem::path& cache);

/// @return The folder of the highest version below `folder`, or nothing where there is none.
std::optional<std::filesystem::path> newestVersion(const std::filesystem::path& folder);

}  // namespace pongsim::assets
