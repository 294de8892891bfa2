#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/files/fuel_address.hh"

namespace pongsim::fuel {

/// A Fuel server that may be asked.
struct Server {
  /// "https://fuel.gazebosim.org"
  std::string url;
  /// Whoever has it may see and change what is private. Empty: none.
  std::string token = {};
};

/// What config.yaml of `ign fuel` says, over what is so anyway.
struct Settings {
  /// fuel.gazebosim.org and fuel.ignitionrobotics.org, and those of the file.
  std::vector<Server> servers;
  /// Those to be listed where the user names none: of the file, else the first.
  std::vector<Server> listed;
  std::filesystem::path cache;
};

/// Reads a configuration, or HOME/.ignition/fuel/config.yaml, if there is one, where none is named. Of the latter the
/// servers count and not `cache`, for Fortress does not read it where it looks for models. IGN_FUEL_CACHE_PATH goes
/// before both.
/// @param warnings What the file says and is not done.
/// @throws Failure with file and line where it can't be read, or says what can't be meant.
Settings readSettings(const std::optional<std::filesystem::path>& file, std::vector<std::string>& warnings);

/// @return The server of an address: its scheme may be another one, and https goes before.
/// @throws Failure where it is none of those that may be asked.
const Server& serverOf(const FuelAddress& address, const Settings& settings);

}  // namespace pongsim::fuel
