#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "pongsim/export.hh"

namespace pongsim {

/// Address of a model or world on a Fuel server, or of a file in one:
/// "https://fuel.gazebosim.org/1.0/OpenRobotics/models/Coke/2/files/meshes/coke.dae".
struct FuelAddress {
  /// "https" or "http".
  std::string scheme = {};
  /// Lower case, with the port if there is one: "localhost:8000".
  std::string host = {};
  /// Version of the server's API.
  std::string apiVersion = "1.0";
  std::string owner = {};
  bool isWorld = false;
  /// Decoded: "%20" is a space.
  std::string name = {};
  /// From 1; unset: the newest.
  std::optional<int> version = {};
  /// A file in it, or empty.
  std::filesystem::path file = {};

  /// @return The address of the model or world, percent-encoded, without version and file.
  PONGSIM_API std::string url() const;
};

/// @return Whether the text is a web address, which in a world file can only be that of a Fuel server.
PONGSIM_API bool isFuelAddress(std::string_view uri);

/// @return Nothing if the text is not the address of a model, a world, or a file in one. No part of it points outside
/// the cache.
PONGSIM_API std::optional<FuelAddress> parseFuelAddress(std::string_view uri);

/// @return The cache folder shared with Gazebo: IGN_FUEL_CACHE_PATH, else GZ_FUEL_CACHE_PATH, else HOME/.ignition/fuel,
/// or HOME/.gz/fuel if only that exists; empty without HOME.
PONGSIM_API std::filesystem::path fuelCacheFolder();

/// @return The folder with the versions in a cache: HOST/OWNER/models/NAME, in lower case like Fortress's.
PONGSIM_API std::filesystem::path fuelFolder(const FuelAddress& address, const std::filesystem::path& cache);

/// @return Whether a version is complete. Fortress unpacks in place and removes the zip file at the end, so a folder
/// with a zip file is incomplete.
PONGSIM_API bool isWholeFuelVersion(const std::filesystem::path& folder);

/// @return The highest complete version in `folder`, or nothing.
PONGSIM_API std::optional<int> newestFuelVersion(const std::filesystem::path& folder);

/// Finds the file or folder of an address. The servers fuel.ignitionrobotics.org and fuel.gazebosim.org count as one.
/// @return The folder of the given version, or of the newest, or the file in it. Nothing if it is not in the cache.
PONGSIM_API std::optional<std::filesystem::path> findInFuelCache(const FuelAddress& address,
                                                                 const std::filesystem::path& cache);

/// @return The server's other name, or empty.
PONGSIM_API std::string otherFuelHost(std::string_view host);

/// @return Whether downloads are disabled: PONGSIM_OFFLINE is set, and not to 0.
PONGSIM_API bool isFuelOffline();

}  // namespace pongsim
