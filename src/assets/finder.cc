#include "assets/finder.hh"

#include <system_error>
#include <utility>
#include <vector>

#include "assets/fuel_address.hh"

namespace pongsim::assets {

namespace fs = std::filesystem;

namespace {

// More are told as a number.
constexpr std::size_t kMostPlacesTold = 4;

bool isThere(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

std::string listOf(const std::vector<fs::path>& places) {
  std::string text;
  for (std::size_t i = 0; i < places.size() && i < kMostPlacesTold; ++i) {
    text += (i > 0 ? ", " : "") + places[i].string();
  }
  if (places.size() > kMostPlacesTold) text += " and " + std::to_string(places.size() - kMostPlacesTold) + " more";
  return text;
}

/// One search, in one place after the other.
class Search {
 public:
  Search(std::string_view uri, const SourcePosition& position, Diagnostics& diagnostics)
      : uri_(uri), position_(position), diagnostics_(diagnostics) {}

  std::optional<fs::path> in(const std::vector<fs::path>& places, const std::string& advice) {
    for (const fs::path& place : places) {
      if (isThere(place)) return place;
    }
    return fail("'" + uri_ + "' is not found", "it was looked for at " + listOf(places) + advice);
  }

  std::nullopt_t fail(std::string message, std::string hint) {
    diagnostics_.error(position_, std::move(message), std::move(hint));
    return std::nullopt;
  }

  /// The cache knows the same servers under an old and a new name.
  std::optional<fs::path> inFuelCache(const fs::path& cache) {
    const std::optional<FuelAddress> address = parseFuelAddress(uri_);
    if (!address) {
      return fail("'" + uri_ + "' is not the address of a Fuel model",
                  "it should read https://fuel.gazebosim.org/1.0/OWNER/models/NAME or .../NAME/VERSION");
    }
    if (cache.empty()) return fail("there is no Fuel cache to find '" + uri_ + "' in", "set IGN_FUEL_CACHE_PATH");
    const bool isOld = address->host == "fuel.ignitionrobotics.org";
    std::vector<fs::path> places;
    for (const std::string& host :
         {address->host, std::string(isOld ? "fuel.gazebosim.org" : "fuel.ignitionrobotics.org")}) {
      const fs::path folder = cacheFolder(*address, host, cache);
      places.push_back(address->version ? folder / std::to_string(*address->version) : folder);
      const std::optional<fs::path> version = address->version ? std::optional(places.back()) : newestVersion(folder);
      if (!version) continue;
      const fs::path found = address->file.empty() ? *version : *version / address->file;
      if (isThere(found)) return found;
    }
    return fail("'" + uri_ + "' is not in the local Fuel cache",
                "it was looked for at " + listOf(places) + "; 'ign fuel download -u ADDRESS' puts it there");
  }

 private:
  const std::string uri_;
  const SourcePosition& position_;
  Diagnostics& diagnostics_;
};

/// @return Where `path` may be: in each of the folders, then in the current one.
std::vector<fs::path> candidates(const fs::path& path, const fs::path* first, const Places& places) {
  if (path.is_absolute()) return {path};
  std::vector<fs::path> all;
  if (first != nullptr) all.push_back(*first / path);
  for (const fs::path& folder : places.folders) all.push_back(folder / path);
  if (first == nullptr || !first->empty()) all.push_back(path);
  return all;
}

std::optional<fs::path> find(const Places& places, std::string_view uri, const fs::path& folder,
                             const SourcePosition& position, Diagnostics& diagnostics) {
  Search search(uri, position, diagnostics);
  if (isFuelAddress(uri)) return search.inFuelCache(places.fuelCache);

  const std::size_t mark = uri.find("://");
  const std::string_view scheme = uri.substr(0, mark == uri.npos ? 0 : mark);
  const std::string_view path = uri.substr(mark == uri.npos ? 0 : mark + 3);
  if (path.empty()) return search.fail("'" + std::string(uri) + "' names nothing", "write model://NAME or a path");
  if (path.find('\0') != path.npos) return search.fail("there is a zero byte in an address", "");
  const bool isModel = scheme == "model" || scheme == "package";
  if (!scheme.empty() && !isModel && scheme != "file") {
    return search.fail("'" + std::string(uri) + "' is an address of an unknown kind",
                       "model://NAME, package://NAME/FILE, file://PATH, paths and addresses of Fuel models are known");
  }
  const std::string advice = places.folders.empty() ? "; PONGSIM_RESOURCE_PATH can name folders to look in" : "";
  return search.in(candidates(path, isModel ? nullptr : &folder, places), advice);
}

}  // namespace

Finder finderIn(Places places) {
  return [places = std::move(places)](std::string_view uri, const fs::path& folder, const SourcePosition& position,
                                      Diagnostics& diagnostics) {
    return find(places, uri, folder, position, diagnostics);
  };
}

Finder finderFromEnvironment() { return finderIn(Places::fromEnvironment()); }

}  // namespace pongsim::assets
