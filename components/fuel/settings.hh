#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/files/fuel_address.hh"

namespace pongsim::fuel {

/// A Fuel server that may be contacted, and the credentials for it.
struct Server {
  /// "https://fuel.gazebosim.org"
  std::string url;
  /// Token for private models, sent with each request; empty: none.
  std::string token = {};
};

/// The settings in config.yaml of `ign fuel`, completed by the defaults.
struct Settings {
  /// The servers of the file, fuel.gazebosim.org and fuel.ignitionrobotics.org.
  std::vector<Server> servers;
  /// The servers that `list` uses if the user names none: those of the file, else the first one.
  std::vector<Server> listed;
  std::filesystem::path cache;
};

/// Reads a configuration; by default HOME/.ignition/fuel/config.yaml, else HOME/.gz/fuel/config.yaml, if one of them
/// exists. In the default file `cache` is ignored, because Fortress ignores it, too, when it searches models.
/// IGN_FUEL_CACHE_PATH and GZ_FUEL_CACHE_PATH take precedence in any case.
/// @param warnings Gets entries of the file that have no effect.
/// @throws Failure with file and line if it can't be read or is invalid.
Settings readSettings(const std::optional<std::filesystem::path>& file, std::vector<std::string>& warnings);

/// @return The server of an address; its scheme may differ from the address's, and https is preferred.
/// @throws Failure if the server may not be contacted.
const Server& serverOf(const FuelAddress& address, const Settings& settings);

}  // namespace pongsim::fuel
