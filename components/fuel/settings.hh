#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/files/fuel_address.hh"

namespace pongsim::fuel {

/// A Fuel server that may be contacted.
struct Server {
  /// "https://fuel.gazebosim.org"
  std::string url;
  /// Gives access to private models. Empty: none.
  std::string token = {};
};

/// The settings of `ign fuel`'s config.yaml, in addition to the defaults.
struct Settings {
  /// fuel.gazebosim.org and fuel.ignitionrobotics.org, and those of the file.
  std::vector<Server> servers;
  /// The servers to list if the user names none: those of the file, else the first.
  std::vector<Server> listed;
  std::filesystem::path cache;
};

/// Reads a configuration; by default HOME/.ignition/fuel/config.yaml, if it exists. Of the default file, the servers
/// are used but not `cache`, because Fortress ignores it when it looks for models. IGN_FUEL_CACHE_PATH takes precedence
/// over both.
/// @param warnings Entries of the file that have no effect.
/// @throws Failure with file and line if it can't be read or is invalid.
Settings readSettings(const std::optional<std::filesystem::path>& file, std::vector<std::string>& warnings);

/// @return The server of an address, whose scheme may differ; https is preferred.
/// @throws Failure if it is not one that may be contacted.
const Server& serverOf(const FuelAddress& address, const Settings& settings);

}  // namespace pongsim::fuel
