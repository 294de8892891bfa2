#include "assets/finder.hh"

#include <algorithm>
#include <functional>
#include <system_error>
#include <utility>
#include <vector>

#include "base/is_below.hh"
#include "pongsim/files/fuel_address.hh"

namespace pongsim::assets {

namespace fs = std::filesystem;

namespace {

// Of more places, a message lists only this many.
constexpr std::size_t kMostPlacesListed = 4;

bool isThere(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

std::string listOf(const std::vector<fs::path>& places) {
  std::string text;
  for (std::size_t i = 0; i < places.size() && i < kMostPlacesListed; ++i) {
    text += (i > 0 ? ", " : "") + places[i].string();
  }
  if (places.size() > kMostPlacesListed) text += " and " + std::to_string(places.size() - kMostPlacesListed) + " more";
  return text;
}

fs::path placeOf(const FuelAddress& address, const fs::path& cache) {
  const fs::path folder = fuelFolder(address, cache);
  return address.version ? folder / std::to_string(*address.version) : folder;
}

constexpr const char* kReach =
    "what is inserted or downloaded finds only files in the world's folder, in those of PONGSIM_RESOURCE_PATH and in "
    "the Fuel cache";

/// Looks for one address, and adds an error if it is nowhere.
class Search {
 public:
  /// @param mayRead Null: everything.
  Search(std::string_view uri, const SourcePosition& position, Diagnostics& diagnostics,
         std::function<bool(const fs::path&)> mayRead)
      : uri_(uri), position_(position), diagnostics_(diagnostics), mayRead_(std::move(mayRead)) {}

  std::optional<fs::path> in(const std::vector<fs::path>& places, const std::string& advice) {
    for (const fs::path& place : places) {
      const fs::path path = mayRead_ ? place.lexically_normal() : place;
      if (isThere(path) && (!mayRead_ || mayRead_(path))) return path;
    }
    // the same whether it is there or not
    if (mayRead_) return fail("'" + uri_ + "' is not found", kReach);
    return fail("'" + uri_ + "' is not found", "looked for it at " + listOf(places) + advice);
  }

  std::nullopt_t fail(std::string message, std::string hint) {
    diagnostics_.error(position_, std::move(message), std::move(hint));
    return std::nullopt;
  }

  std::optional<fs::path> inFuelCache(const fs::path& cache, FuelFetch* fetch) {
    const std::optional<FuelAddress> address = parseFuelAddress(uri_);
    if (!address) {
      return fail("'" + uri_ + "' is not the address of a Fuel model or world",
                  "write https://fuel.gazebosim.org/1.0/OWNER/models/NAME or .../NAME/VERSION");
    }
    if (cache.empty()) return fail("there is no Fuel cache to look in for '" + uri_ + "'", "set IGN_FUEL_CACHE_PATH");
    if (std::optional<fs::path> found = findInFuelCache(*address, cache)) return in({*found}, "");
    if (fetch != nullptr) {
      fetch->bring({uri_});
      if (std::optional<fs::path> found = findInFuelCache(*address, cache)) return found;
    }
    // if the model is in the cache, the file does not exist, and a download would not help
    FuelAddress whole = *address;
    whole.file.clear();
    const std::optional<fs::path> model = address->file.empty() ? std::nullopt : findInFuelCache(whole, cache);
    if (model) {
      return fail("'" + uri_ + "' is not found", "there is no '" + address->file.string() + "' in " + model->string());
    }
    if (fetch != nullptr) {
      Problem problem = fetch->whyNot(uri_);
      return fail(std::move(problem.text), std::move(problem.hint));
    }
    std::vector<fs::path> places{placeOf(*address, cache)};
    if (FuelAddress other = *address; !(other.host = otherFuelHost(address->host)).empty()) {
      places.push_back(placeOf(other, cache));
    }
    return fail("'" + uri_ + "' is not in the local Fuel cache",
                "looked for it at " + listOf(places) + "; download it with 'pongsim fuel download -u ADDRESS'");
  }

 private:
  const std::string uri_;
  const SourcePosition& position_;
  Diagnostics& diagnostics_;
  const std::function<bool(const fs::path&)> mayRead_;
};

/// @return The possible locations of `path`: each of the folders, then the current one.
std::vector<fs::path> candidates(const fs::path& path, const fs::path* first, const Places& places) {
  if (path.is_absolute()) return {path};
  std::vector<fs::path> all;
  if (first != nullptr) all.push_back(*first / path);
  for (const fs::path& folder : places.folders) all.push_back(folder / path);
  if (first == nullptr || !first->empty()) all.push_back(path);
  return all;
}

}  // namespace

Finder::Finder(Places places, std::shared_ptr<FuelFetch> fetch)
    : places_(std::move(places)), fetch_(std::move(fetch)) {}

std::optional<fs::path> Finder::operator()(std::string_view uri, const fs::path& folder, const SourcePosition& position,
                                           Diagnostics& diagnostics) const {
  std::function<bool(const fs::path&)> mayReadHere;
  if (isConfined(folder)) mayReadHere = [&](const fs::path& file) { return mayRead(file, folder); };
  Search search(uri, position, diagnostics, std::move(mayReadHere));
  if (isFuelAddress(uri)) return search.inFuelCache(places_.fuelCache, fetch_.get());

  const std::size_t mark = uri.find("://");
  const std::string_view scheme = uri.substr(0, mark == uri.npos ? 0 : mark);
  const std::string_view path = uri.substr(mark == uri.npos ? 0 : mark + 3);
  if (path.empty()) return search.fail("'" + std::string(uri) + "' contains no name", "write model://NAME or a path");
  if (path.find('\0') != path.npos) return search.fail("an address contains a zero byte", "");
  const bool isModel = scheme == "model" || scheme == "package";
  if (!scheme.empty() && !isModel && scheme != "file") {
    return search.fail("'" + std::string(uri) + "' is not a supported kind of address",
                       "use model://NAME, package://NAME/FILE, file://PATH, a path or the address of a Fuel model");
  }
  const std::string advice = places_.folders.empty() ? "; set PONGSIM_RESOURCE_PATH to search more folders" : "";
  return search.in(candidates(path, isModel ? nullptr : &folder, places_), advice);
}

namespace {

/// @return Whether the path of a file says that it lies in a folder, without following links.
bool isWrittenBelow(const fs::path& file, const fs::path& folder) {
  // behind a link, ".." leads elsewhere than it is written
  if (folder.empty() || std::ranges::find(file, fs::path("..")) != file.end()) return false;
  std::error_code ignored;
  const fs::path path = fs::absolute(file, ignored).lexically_normal();
  // without a separator at its end, which would be an empty part
  const fs::path above = (fs::absolute(folder, ignored) / "").lexically_normal().parent_path();
  return std::ranges::mismatch(above, path).in1 == above.end();
}

}  // namespace

Finder Finder::confinedTo(Reach reach) const {
  Finder confined = *this;
  confined.reach_ = std::move(reach);
  return confined;
}

bool Finder::isConfined(const fs::path& folder) const {
  if (reach_ || places_.fuelCache.empty()) return reach_.has_value();
  const auto [place, isNew] = areFromServer_.try_emplace(folder, false);
  if (isNew) place->second = base::isBelow(folder, places_.fuelCache);
  return place->second;
}

bool Finder::mayRead(const fs::path& file, const fs::path& folder) const {
  if (!isConfined(folder)) return true;
  const auto holds = [&](const fs::path& each) { return base::isBelow(file, each); };
  if (holds(places_.fuelCache)) return true;
  // folders that requests have added are places, but none of them widens what may be read
  if (!reach_) return std::ranges::any_of(places_.folders, holds);
  return holds(reach_->world) || std::ranges::any_of(reach_->folders, [&](const fs::path& each) {
           return holds(each) || isWrittenBelow(file, each);
         });
}

void Finder::bring(const std::vector<std::string>& addresses) const {
  if (fetch_ != nullptr) fetch_->bring(addresses);
}

Finder finderIn(Places places) { return Finder(std::move(places)); }

Finder finderFromEnvironment() {
  const Places places = Places::fromEnvironment();
  return Finder(places, std::make_shared<FuelFetch>(places));
}

}  // namespace pongsim::assets
