#include "fuel/actions.hh"

#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <map>
#include <system_error>

#include "fuel/cache.hh"
#include "fuel/downloads.hh"
#include "fuel/failure.hh"
#include "fuel/listing.hh"
#include "fuel/server.hh"
#include "fuel/settings.hh"
#include "shared/program/console.hh"

namespace pongsim::fuel::actions {

namespace fs = std::filesystem;

namespace {

/// The settings and the progress display, which all actions need.
struct Session {
  explicit Session(const Options& options)
      : progress(options.verbosity, options.verbosity >= kUsualVerbosity && isatty(STDERR_FILENO) == 1) {
    std::vector<std::string> warnings;
    settings = readSettings(options.config ? std::optional<fs::path>(*options.config) : std::nullopt, warnings);
    for (const std::string& warning : warnings) progress.warning(warning);
  }
  Progress progress;
  Settings settings;
};

bool isWorldType(const std::string& type) {
  if (type != "model" && type != "world") throw UsageError("'" + type + "' is not a type", "use model or world");
  return type == "world";
}

/// @return The addresses that the user has given, as options and as arguments.
std::vector<std::string> givenAddresses(const Options& options) {
  std::vector<std::string> all = options.addresses;
  if (options.url) all.insert(all.begin(), *options.url);
  if (all.empty()) {
    throw UsageError("no address given", "for example https://fuel.gazebosim.org/1.0/OpenRobotics/models/Ambulance");
  }
  return all;
}

FuelAddress addressFrom(const std::string& text) {
  std::optional<FuelAddress> address = parseFuelAddress(text);
  if (!address) {
    throw UsageError("'" + text + "' is not the address of a model or world",
                     "write https://fuel.gazebosim.org/1.0/OWNER/models/NAME or .../NAME/VERSION");
  }
  return *address;
}

FuelAddress oneAddress(const Options& options) {
  const std::vector<std::string> all = givenAddresses(options);
  if (all.size() > 1) throw UsageError("give only one address");
  return addressFrom(all.front());
}

/// @return The server of "-u URL", which need not be in the configuration.
Server serverFrom(const std::string& url, const Settings& settings) {
  std::string plain = url;
  while (plain.ends_with('/')) plain.pop_back();
  const bool isWeb = plain.starts_with("https://") || plain.starts_with("http://");
  if (!isWeb || originOf(plain).size() != plain.size()) {
    throw UsageError("'" + url + "' is not the address of a server", "such as https://fuel.gazebosim.org");
  }
  plain = originOf(plain);
  const auto known = std::ranges::find(settings.servers, plain, &Server::url);
  return known != settings.servers.end() ? *known : Server{plain};
}

void requireNetwork(const Options& options, const std::string& instead) {
  if (options.offline || isFuelOffline())
    throw Failure("the network is off: --offline or PONGSIM_OFFLINE is set", instead);
}

int listCached(const Options& options, bool worlds, const Session& session) {
  std::map<std::string, Listing> byHost;
  std::string lines;
  const std::optional<Server> wanted =
      options.url ? std::optional(serverFrom(*options.url, session.settings)) : std::nullopt;
  for (const CachedVersion& each : cachedVersions(session.settings.cache)) {
    const FuelAddress& address = each.address;
    if (address.isWorld != worlds || (wanted && originOf(wanted->url) != "https://" + address.host &&
                                      originOf(wanted->url) != "http://" + address.host))
      continue;
    if (options.owner && fuelFolder(address, "").parent_path().parent_path().filename() != *options.owner) {
      FuelAddress other = address;
      other.owner = *options.owner;
      if (fuelFolder(other, "") != fuelFolder(address, "")) continue;
    }
    const std::string version = std::to_string(*address.version);
    byHost[address.host][address.owner].push_back(address.name + " " + version +
                                                  (isWholeFuelVersion(each.folder) ? "" : " (incomplete)"));
    lines += address.url() + "/" + version + "\n";
  }
  if (options.raw) {
    cli::print(lines);
    return cli::kDone;
  }
  if (byHost.empty())
    cli::print("The cache " + session.settings.cache.string() + " has no " + (worlds ? "worlds" : "models") + ".\n");
  for (const auto& [host, listing] : byHost)
    cli::print(treeOf(host, listing, worlds ? "worlds" : "models", cli::hasColors(STDOUT_FILENO)));
  return cli::kDone;
}

/// @return The cached versions of a model, one per line.
std::string cachedText(const FuelAddress& address, const Settings& settings) {
  std::string text;
  for (const std::string& host : {address.host, otherFuelHost(address.host)}) {
    FuelAddress there = address;
    there.host = host;
    const fs::path folder = fuelFolder(there, settings.cache);
    for (const CachedVersion& each : cachedVersions(settings.cache)) {
      if (host.empty() || each.folder.parent_path() != folder) continue;
      text += "Cached: version " + std::to_string(*each.address.version) + " in " + each.folder.string() +
              (isWholeFuelVersion(each.folder) ? "" : ", incomplete") + "\n";
    }
  }
  return text;
}

/// @return The addresses, in which each collection is replaced by its content.
std::vector<FuelAddress> resolved(const Options& options, const Settings& settings) {
  std::vector<FuelAddress> all;
  const bool models = !options.type || !isWorldType(*options.type), worlds = !options.type || !models;
  for (const std::string& text : givenAddresses(options)) {
    const std::optional<Collection> collection = parseCollection(text);
    if (!collection) {
      all.push_back(addressFrom(text));
      continue;
    }
    requireNetwork(options, "only the server knows what a collection contains");
    FuelServer server(serverOf(collection->server, settings), options.headers);
    const std::size_t before = all.size();
    for (const bool isWorld : {false, true}) {
      if (isWorld ? !worlds : !models) continue;
      for (const Details& each : server.list(isWorld, *collection)) {
        FuelAddress address = collection->server;
        address.isWorld = isWorld;
        address.owner = each.owner;
        address.name = each.name;
        // an address in a server's response is not trusted: it could contain "..", and lead out of the cache
        if (parseFuelAddress(address.url())) all.push_back(address);
      }
    }
    if (all.size() == before) throw Failure("the collection is empty: '" + text + "'");
  }
  return all;
}

int reportOf(const std::vector<DownloadResult>& results) {
  int code = cli::kDone;
  for (const DownloadResult& each : results) {
    if (!each.folder.empty()) continue;
    const std::string version = each.address.version ? "/" + std::to_string(*each.address.version) : "";
    cli::sayError("'" + each.address.url() + version + "' can't be downloaded: " + each.why, each.hint);
    code = cli::kFailed;
  }
  return code;
}

int removeCached(const FuelAddress& address, const Session& session) {
  std::size_t count = 0;
  for (const CachedVersion& each : cachedVersions(session.settings.cache)) {
    FuelAddress there = address;
    for (const std::string& host : {address.host, otherFuelHost(address.host)}) {
      there.host = host;
      if (host.empty() || each.folder.parent_path() != fuelFolder(there, session.settings.cache)) continue;
      if (address.version && address.version != each.address.version) continue;
      const Workplace workplace(each.address, session.settings.cache);
      Lock lock(workplace.lock);
      lock.take();
      // renamed before it is deleted, so that no process finds an incomplete version in the cache
      std::error_code error;
      fs::remove_all(workplace.folder, error);
      fs::rename(each.folder, workplace.folder, error);
      if (!error) fs::remove_all(workplace.folder, error);
      if (error) throw Failure("'" + each.folder.string() + "' can't be deleted: " + error.message());
      fs::remove(each.folder.parent_path(), error);
      cli::print("deleted " + each.folder.string() + "\n");
      ++count;
    }
  }
  if (count == 0) throw Failure("'" + address.url() + "' is not in the cache");
  return cli::kDone;
}

}  // namespace

int list(const Options& options) {
  if (!options.type) throw UsageError("no type given", "-t model or -t world");
  const bool worlds = isWorldType(*options.type);
  Session session(options);
  if (options.cached) return listCached(options, worlds, session);
  requireNetwork(options, "--cached lists what the cache has");
  const std::vector<Server> servers =
      options.url ? std::vector{serverFrom(*options.url, session.settings)} : session.settings.listed;
  const std::string kind = worlds ? "world" : "model";
  for (const Server& server : servers) {
    const auto start = std::chrono::steady_clock::now();
    if (!options.raw) cli::print("Fetching " + kind + " list from " + server.url + "...\n");
    const Listing listing = listingOf(FuelServer(server, options.headers).list(worlds, options.owner.value_or("")));
    if (options.raw) {
      cli::print(addressesOf(server.url, listing, worlds));
      continue;
    }
    const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - start);
    cli::print("Received " + kind + " list (took " + std::to_string(ms.count()) + "ms).\n");
    cli::print(treeOf(server.url, listing, kind + "s", cli::hasColors(STDOUT_FILENO)));
  }
  return cli::kDone;
}

int info(const Options& options) {
  const FuelAddress address = oneAddress(options);
  Session session(options);
  const std::string cached = cachedText(address, session.settings);
  if (options.offline || isFuelOffline() || options.cached) {
    if (cached.empty()) throw Failure("'" + address.url() + "' is not in the cache");
    cli::print(address.url() + "\n" + cached);
    return cli::kDone;
  }
  FuelServer server(serverOf(address, session.settings), options.headers);
  cli::print(address.url() + "\n" + descriptionOf(server.details(address)) + cached);
  return cli::kDone;
}

int download(const Options& options) {
  if (options.type) isWorldType(*options.type);
  Session session(options);
  const DownloadOptions how{
      .jobs = options.jobs, .isUpdate = !options.offline && !isFuelOffline(), .headers = options.headers};
  const std::vector<FuelAddress> addresses = resolved(options, session.settings);
  std::vector<DownloadResult> results;
  {
    Downloads downloads(session.settings, how, session.progress);
    results = downloads.run(addresses);
  }
  return reportOf(results);
}

int update(const Options& options) {
  Session session(options);
  requireNetwork(options, "only a server knows what is new");
  std::vector<FuelAddress> addresses;
  for (const CachedVersion& each : cachedVersions(session.settings.cache)) {
    if (each.address.isWorld ? options.onlyModels : options.onlyWorlds) continue;
    FuelAddress address = each.address;
    address.version.reset();
    if (addresses.empty() || keyOf(addresses.back()) != keyOf(address)) addresses.push_back(address);
  }
  const DownloadOptions how{.jobs = options.jobs, .isUpdate = true, .headers = options.headers};
  Downloads downloads(session.settings, how, session.progress);
  return reportOf(downloads.run(addresses));
}

int remove(const Options& options) {
  const FuelAddress address = oneAddress(options);
  if (!address.file.empty()) throw UsageError("single files can't be deleted");
  Session session(options);
  if (options.cached) return removeCached(address, session);
  requireNetwork(options, "use --cached to delete it from the cache");
  if (address.version)
    throw UsageError("a server can't delete a single version", "use --cached to delete it from the cache");
  const Server& server = serverOf(address, session.settings);
  if (options.headers.empty() && server.token.empty()) {
    throw UsageError("deleting it from the server needs a token: --header 'Private-Token: TOKEN'",
                     "use --cached to delete it from the cache of this machine");
  }
  FuelServer(server, options.headers).remove(address);
  cli::print("deleted " + address.url() + " on the server\n");
  return cli::kDone;
}

int check(const Options& options) {
  Session session(options);
  std::size_t models = 0, worlds = 0, broken = 0;
  for (const CachedVersion& each : cachedVersions(session.settings.cache)) {
    ++(each.address.isWorld ? worlds : models);
    const std::vector<std::string> faults = faultsOf(each);
    for (const std::string& fault : faults) cli::print(each.folder.string() + ": " + fault + "\n");
    if (faults.empty()) continue;
    ++broken;
    const std::string address = each.address.url() + "/" + std::to_string(*each.address.version);
    cli::print("  hint: pongsim fuel delete --cached -u " + address + " && pongsim fuel download -u " + address + "\n");
  }
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(session.settings.cache / ".pongsim", error)) {
    if (entry.path().extension() != ".zip") continue;
    cli::print(entry.path().stem().string() + ": " + sizeText(sizeOf(entry.path())) +
               " of an interrupted download; the next one resumes it\n");
  }
  cli::print(std::to_string(models) + (models == 1 ? " model, " : " models, ") + std::to_string(worlds) +
             (worlds == 1 ? " world: " : " worlds: ") +
             (broken == 0 ? "all complete" : std::to_string(broken) + " broken") + "\n");
  return broken == 0 ? cli::kDone : cli::kFailed;
}

int fetch(const Options& options) {
  // the process ends with its parent, the loader of worlds, which reads the results
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  std::vector<std::string> lines;
  std::vector<FuelAddress> addresses;
  for (std::string line; std::getline(std::cin, line);) {
    if (const auto address = parseFuelAddress(line)) {
      lines.push_back(line);
      addresses.push_back(*address);
    }
  }
  const auto plain = [](std::string text) {
    std::ranges::replace_if(
        text, [](char each) { return each == '\t' || each == '\n'; }, ' ');
    return text;
  };
  std::vector<DownloadResult> results;
  try {
    Session session(options);
    const DownloadOptions how{.jobs = options.jobs};
    Downloads downloads(session.settings, how, session.progress);
    results = downloads.run(addresses);
  } catch (const Failure& failure) {
    for (const std::string& line : lines) {
      cli::print("failed " + line + "\t" + plain(failure.what()) + "\t" + plain(failure.hint()) + "\n");
    }
    return cli::kFailed;
  }
  int code = cli::kDone;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string key = keyOf(addresses[i]);
    const auto result = std::ranges::find(results, key, [](const DownloadResult& each) { return keyOf(each.address); });
    if (result != results.end() && !result->folder.empty()) {
      cli::print("ok " + lines[i] + "\n");
    } else if (result != results.end()) {
      code = cli::kFailed;
      cli::print("failed " + lines[i] + "\t" + plain(result->why) + "\t" + plain(result->hint) + "\n");
    }
  }
  return code;
}

}  // namespace pongsim::fuel::actions
