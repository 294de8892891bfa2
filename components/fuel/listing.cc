#include "fuel/listing.hh"

#include <algorithm>
#include <iterator>

#include "fuel/progress.hh"
#include "pongsim/files/fuel_address.hh"

namespace pongsim::fuel {

namespace {

std::string colored(const std::string& text, const char* code, bool hasColors) {
  return hasColors ? std::string(code) + text + "\x1b[0m" : text;
}

std::string counted(std::size_t count, const std::string& things) { return std::to_string(count) + " " + things; }

}  // namespace

Listing listingOf(const std::vector<Details>& all) {
  Listing listing;
  for (const Details& each : all) listing[each.owner].push_back(each.name);
  for (auto& [owner, names] : listing) {
    std::ranges::sort(names);
    names.erase(std::unique(names.begin(), names.end()), names.end());
  }
  return listing;
}

std::string treeOf(const std::string& server, const Listing& listing, const std::string& kind, bool hasColors) {
  std::string text = colored(server, "\x1b[92m\x1b[1m", hasColors) + "\n";
  std::size_t count = 0;
  for (auto owner = listing.begin(); owner != listing.end(); ++owner) {
    const bool isLast = std::next(owner) == listing.end();
    text += (isLast ? "└── " : "├── ") + colored(owner->first, "\x1b[93m\x1b[1m", hasColors) + "\n";
    for (const std::string& name : owner->second) {
      text += std::string(isLast ? "    " : "│   ") + (&name == &owner->second.back() ? "└── " : "├── ") + name + "\n";
    }
    count += owner->second.size();
  }
  return text + colored(counted(listing.size(), "owners, ") + counted(count, kind), "\x1b[36m", hasColors) + "\n";
}

std::string addressesOf(const std::string& server, const Listing& listing, bool worlds) {
  std::string text;
  for (const auto& [owner, names] : listing) {
    for (const std::string& name : names) {
      FuelAddress address;
      address.scheme = server.substr(0, server.find("://"));
      address.host = server.substr(server.find("://") + 3);
      address.owner = owner;
      address.isWorld = worlds;
      address.name = name;
      text += address.url() + "\n";
    }
  }
  return text;
}

std::string descriptionOf(const Details& details) {
  std::string text;
  const auto add = [&](const std::string& label, const std::string& value) {
    if (!value.empty()) text += label + ": " + value + "\n";
  };
  add("Name", details.name);
  add("Owner", details.owner);
  add("Version", details.version > 0 ? std::to_string(details.version) : "");
  add("Size", details.bytes > 0 ? sizeText(details.bytes) : "");
  add("License", details.license);
  add("Created", details.created);
  add("Updated", details.updated);
  add("Private", details.isPrivate ? "yes" : "");
  std::string tags;
  for (const std::string& tag : details.tags) tags += (tags.empty() ? "" : ", ") + tag;
  add("Tags", tags);
  add("Description", details.description);
  return text;
}

}  // namespace pongsim::fuel
