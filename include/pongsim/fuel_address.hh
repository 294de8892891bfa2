#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "pongsim/export.hh"

namespace pongsim {

/// A model or world on a Fuel server, or a file of one:
/// "https://fuel.gazebosim.org/1.0/OpenRobotics/models/Coke/2/files/meshes/coke.dae".
struct FuelAddress {
  /// "https" or "http".
  std::string scheme = {};
  /// In lower case, with the port where there is one: "localhost:8000".
  std::string host = {};
  /// Of the server's interface.
  std::string apiVersion = "1.0";
  std::string owner = {};
  bool isWorld = false;
  /// As it stands in the address, with "%20" made a space.
  std::string name = {};
  /// From 1 up. Nothing: the newest.
  std::optional<int> version = {};
  /// A file of it, or empty.
  std::filesystem::path file = {};

  /// @return The address of the model or world, with what is special in it as "%20" and so on, without version and
  /// file.
  PONGSIM_API std::string url() const;
};

/// @return Whether the text is an address of the web, which in a world file can be that of a Fuel server only.
PONGSIM_API bool isFuelAddress(std::string_view uri);

/// @return Nothing where the text is not the address of a model, a world, or a file of one. No part of it leads out of
/// the cache.
PONGSIM_API std::optional<FuelAddress> parseFuelAddress(std::string_view uri);

/// @return Where Fortress and pongsim keep what they have downloaded: IGN_FUEL_CACHE_PATH, else HOME/.ignition/fuel,
/// else nowhere: empty.
PONGSIM_API std::filesystem::path fuelCacheFolder();

/// @return Where a cache keeps the versions: HOST/OWNER/models/NAME, in lower case, as Fortress writes them.
PONGSIM_API std::filesystem::path fuelFolder(const FuelAddress& address, const std::filesystem::path& cache);

/// @return Whether a version is there as a whole. Fortress unpacks in place, beside the zip file, which it removes at
/// the end: a folder that still has it is being filled, or was left so.
PONGSIM_API bool isWholeFuelVersion(const std::filesystem::path& folder);

/// @return The highest version below `folder` that is whole, or nothing where there is none.
PONGSIM_API std::optional<int> newestFuelVersion(const std::filesystem::path& folder);

/// Finds what an address names. The servers fuel.ignitionrobotics.org and fuel.gazebosim.org are the same one.
/// @return The folder of the version that is asked for, of the newest where none is, or the file in it. Nothing where
/// it is not in the cache.
PONGSIM_API std::optional<std::filesystem::path> findInFuelCache(const FuelAddress& address,
                                                                 const std::filesystem::path& cache);

/// @return The same server's other name, or empty.
PONGSIM_API std::string otherFuelHost(std::string_view host);

/// @return Whether the user wants nothing to be downloaded: PONGSIM_OFFLINE is set, and not to 0.
PONGSIM_API bool isFuelOffline();

}  // namespace pongsim
