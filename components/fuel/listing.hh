#pragma once

#include <map>
#include <string>
#include <vector>

#include "fuel/server.hh"

namespace pongsim::fuel {

/// The names of models or worlds, keyed by owner.
using Listing = std::map<std::string, std::vector<std::string>>;

Listing listingOf(const std::vector<Details>& all);

/// @return A tree of owners and names below the server's address, as `ign fuel list` prints it.
/// @param kind "models"
std::string treeOf(const std::string& server, const Listing& listing, const std::string& kind, bool hasColors);

/// @return One address per line.
std::string addressesOf(const std::string& server, const Listing& listing, bool worlds);

/// @return Information about a model or world, one line each.
std::string descriptionOf(const Details& details);

}  // namespace pongsim::fuel
