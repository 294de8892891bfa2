#include "fuel/command.hh"

#include <sys/prctl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <optional>
#include <system_error>

#include "fuel/cache.hh"
#include "fuel/console.hh"
#include "fuel/downloads.hh"
#include "fuel/failure.hh"
#include "fuel/interruption.hh"
#include "fuel/listing.hh"
#include "fuel/server.hh"
#include "fuel/settings.hh"

namespace pongsim::fuel {

namespace fs = std::filesystem;

namespace {

constexpr int kUsual = 3;

struct Options {
  std::vector<std::string> addresses;
  std::optional<std::string> url, config, type, owner;
  std::vector<std::string> headers;
  int verbosity = kUsual;
  std::size_t jobs = 4;
  bool raw = false, cached = false, offline = false, onlyModels = false, onlyWorlds = false;
};

/// What all actions begin with.
struct Session {
  explicit Session(const Options& options)
      : progress(options.verbosity, options.verbosity >= kUsual && isatty(STDERR_FILENO) == 1) {
    std::vector<std::string> warnings;
    settings = readSettings(options.config ? std::optional<fs::path>(*options.config) : std::nullopt, warnings);
    for (const std::string& warning : warnings) progress.warning(warning);
  }
  Progress progress;
  Settings settings;
};

void checkHeaders(const std::vector<std::string>& headers) {
  for (const std::string& header : headers) {
    const std::size_t colon = header.find(':');
    if (colon == 0 || colon == std::string::npos || header.find_first_of("\r\n") != std::string::npos) {
      throw UsageError("'" + header + "' is no header", "write --header 'Private-Token: TOKEN'");
    }
  }
}

bool isWorldType(const std::string& type) {
  if (type != "model" && type != "world")
    throw UsageError("'" + type + "' is no type", "the types are model and world");
  return type == "world";
}

/// @return The addresses that the user gave, in both ways.
std::vector<std::string> givenAddresses(const Options& options) {
  std::vector<std::string> all = options.addresses;
  if (options.url) all.insert(all.begin(), *options.url);
  if (all.empty()) {
    throw UsageError("no address given", "as https://fuel.gazebosim.org/1.0/OpenRobotics/models/Ambulance");
  }
  return all;
}

FuelAddress addressFrom(const std::string& text) {
  std::optional<FuelAddress> address = parseFuelAddress(text);
  if (!address) {
    throw UsageError("'" + text + "' is not the address of a model or world",
                     "it should read https://fuel.gazebosim.org/1.0/OWNER/models/NAME or .../NAME/VERSION");
  }
  return *address;
}

FuelAddress oneAddress(const Options& options) {
  const std::vector<std::string> all = givenAddresses(options);
  if (all.size() > 1) throw UsageError("one address at a time");
  return addressFrom(all.front());
}

/// @return The server of "-u URL", which need not be one of the configuration.
Server serverFrom(const std::string& url, const Settings& settings) {
  std::string plain = url;
  while (plain.ends_with('/')) plain.pop_back();
  const bool isWeb = plain.starts_with("https://") || plain.starts_with("http://");
  if (!isWeb || originOf(plain).size() != plain.size()) {
    throw UsageError("'" + url + "' is not the address of a server", "as https://fuel.gazebosim.org");
  }
  plain = originOf(plain);
  const auto known = std::ranges::find(settings.servers, plain, &Server::url);
  return known != settings.servers.end() ? *known : Server{plain};
}

void requireNetwork(const Options& options, const std::string& instead) {
  if (options.offline || isFuelOffline())
    throw Failure("nothing is asked of the network: --offline or PONGSIM_OFFLINE says so", instead);
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
                                                  (isWholeFuelVersion(each.folder) ? "" : " (not whole)"));
    lines += address.url() + "/" + version + "\n";
  }
  if (options.raw) {
    print(lines);
    return kDone;
  }
  if (byHost.empty())
    print("The cache " + session.settings.cache.string() + " has no " + (worlds ? "worlds" : "models") + ".\n");
  for (const auto& [host, listing] : byHost)
    print(treeOf(host, listing, worlds ? "worlds" : "models", outputHasColors()));
  return kDone;
}

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
    if (!options.raw) print("Fetching " + kind + " list from " + server.url + "...\n");
    const Listing listing = listingOf(FuelServer(server, options.headers).list(worlds, options.owner.value_or("")));
    if (options.raw) {
      print(addressesOf(server.url, listing, worlds));
      continue;
    }
    const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - start);
    print("Received " + kind + " list (took " + std::to_string(ms.count()) + "ms).\n");
    print(treeOf(server.url, listing, kind + "s", outputHasColors()));
  }
  return kDone;
}

/// @return What the cache has of a model, a line each.
std::string cachedText(const FuelAddress& address, const Settings& settings) {
  std::string text;
  for (const std::string& host : {address.host, otherFuelHost(address.host)}) {
    FuelAddress there = address;
    there.host = host;
    const fs::path folder = fuelFolder(there, settings.cache);
    for (const CachedVersion& each : cachedVersions(settings.cache)) {
      if (host.empty() || each.folder.parent_path() != folder) continue;
      text += "Cached: version " + std::to_string(*each.address.version) + " in " + each.folder.string() +
              (isWholeFuelVersion(each.folder) ? "" : ", not whole") + "\n";
    }
  }
  return text;
}

int info(const Options& options) {
  const FuelAddress address = oneAddress(options);
  Session session(options);
  const std::string cached = cachedText(address, session.settings);
  if (options.offline || isFuelOffline() || options.cached) {
    if (cached.empty()) throw Failure("'" + address.url() + "' is not in the cache");
    print(address.url() + "\n" + cached);
    return kDone;
  }
  FuelServer server(serverOf(address, session.settings), options.headers);
  print(address.url() + "\n" + descriptionOf(server.details(address)) + cached);
  return kDone;
}

/// @return The addresses, with what is in collections in place of these.
std::vector<FuelAddress> resolved(const Options& options, const Settings& settings) {
  std::vector<FuelAddress> all;
  const bool models = !options.type || !isWorldType(*options.type), worlds = !options.type || !models;
  for (const std::string& text : givenAddresses(options)) {
    const std::optional<Collection> collection = parseCollection(text);
    if (!collection) {
      all.push_back(addressFrom(text));
      continue;
    }
    requireNetwork(options, "of a collection the server knows what is in it");
    FuelServer server(serverOf(collection->server, settings), options.headers);
    const std::size_t before = all.size();
    for (const bool isWorld : {false, true}) {
      if (isWorld ? !worlds : !models) continue;
      for (const Details& each : server.list(isWorld, *collection)) {
        FuelAddress address = collection->server;
        address.isWorld = isWorld;
        address.owner = each.owner;
        address.name = each.name;
        // what a server says is not to lead out of the cache
        if (parseFuelAddress(address.url())) all.push_back(address);
      }
    }
    if (all.size() == before) throw Failure("there is nothing in the collection '" + text + "'");
  }
  return all;
}

int reportOf(const std::vector<DownloadResult>& results) {
  int code = kDone;
  for (const DownloadResult& each : results) {
    if (!each.folder.empty()) continue;
    const std::string version = each.address.version ? "/" + std::to_string(*each.address.version) : "";
    sayError("'" + each.address.url() + version + "' can't be downloaded: " + each.why, each.hint);
    code = kFailed;
  }
  return code;
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
  requireNetwork(options, "what is new only a server knows");
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
      // out of sight in one go, then away
      std::error_code error;
      fs::remove_all(workplace.folder, error);
      fs::rename(each.folder, workplace.folder, error);
      if (!error) fs::remove_all(workplace.folder, error);
      if (error) throw Failure("'" + each.folder.string() + "' can't be deleted: " + error.message());
      fs::remove(each.folder.parent_path(), error);
      print("deleted " + each.folder.string() + "\n");
      ++count;
    }
  }
  if (count == 0) throw Failure("'" + address.url() + "' is not in the cache");
  return kDone;
}

int remove(const Options& options) {
  const FuelAddress address = oneAddress(options);
  if (!address.file.empty()) throw UsageError("single files can't be deleted");
  Session session(options);
  if (options.cached) return removeCached(address, session);
  requireNetwork(options, "--cached deletes it from the cache");
  if (address.version)
    throw UsageError("a server has no way to delete one version", "--cached deletes it from the cache");
  const Server& server = serverOf(address, session.settings);
  if (options.headers.empty() && server.token.empty()) {
    throw UsageError("to delete it from the server takes a token: --header 'Private-Token: TOKEN'",
                     "--cached deletes it from the cache of this machine");
  }
  FuelServer(server, options.headers).remove(address);
  print("deleted " + address.url() + " on the server\n");
  return kDone;
}

int check(const Options& options) {
  Session session(options);
  std::size_t models = 0, worlds = 0, broken = 0;
  for (const CachedVersion& each : cachedVersions(session.settings.cache)) {
    ++(each.address.isWorld ? worlds : models);
    const std::vector<std::string> faults = faultsOf(each);
    for (const std::string& fault : faults) print(each.folder.string() + ": " + fault + "\n");
    if (faults.empty()) continue;
    ++broken;
    const std::string address = each.address.url() + "/" + std::to_string(*each.address.version);
    print("  hint: pongsim fuel delete --cached -u " + address + " && pongsim fuel download -u " + address + "\n");
  }
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(session.settings.cache / ".pongsim", error)) {
    if (entry.path().extension() != ".zip") continue;
    print(entry.path().stem().string() + ": " + sizeText(sizeOf(entry.path())) +
          " of a download that was broken off; the next one goes on with them\n");
  }
  print(std::to_string(models) + (models == 1 ? " model, " : " models, ") + std::to_string(worlds) +
        (worlds == 1 ? " world: " : " worlds: ") + (broken == 0 ? "all whole" : std::to_string(broken) + " broken") +
        "\n");
  return broken == 0 ? kDone : kFailed;
}

/// What the loader of worlds asks for: addresses come by standard input, a line each, and what has come of them goes to
/// standard output, a line each: "ok ADDRESS" or "failed ADDRESS", why and advice with tabs between them.
int fetch(const Options& options) {
  // who has asked is gone: nobody waits
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
      print("failed " + line + "\t" + plain(failure.what()) + "\t" + plain(failure.hint()) + "\n");
    }
    return kFailed;
  }
  int code = kDone;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string key = keyOf(addresses[i]);
    const auto result = std::ranges::find(results, key, [](const DownloadResult& each) { return keyOf(each.address); });
    if (result != results.end() && !result->folder.empty()) {
      print("ok " + lines[i] + "\n");
    } else if (result != results.end()) {
      code = kFailed;
      print("failed " + lines[i] + "\t" + plain(result->why) + "\t" + plain(result->hint) + "\n");
    }
  }
  return code;
}

using Action = int (*)(const Options&);

CLI::App* addAction(CLI::App& program, const char* name, const char* help, Action action, Options& options,
                    Action& chosen) {
  CLI::App* command = program.add_subcommand(name, help);
  command->set_help_flag("-h,--help", "Print this and end");
  command
      ->add_option("-c,--config", options.config,
                   "Configuration with servers, tokens and cache (~/.ignition/fuel/config.yaml)")
      ->type_name("FILE");
  command
      ->add_option_function<std::string>(
          "-v,--verbose",
          [&options](const std::string& text) {
            // "-v" alone, as in Fortress
            if (text.empty()) return;
            if (text.size() != 1 || text[0] < '0' || text[0] > '4') {
              throw UsageError("option '-v' takes a level from 0 to 4, not '" + text + "'");
            }
            options.verbosity = text[0] - '0';
          },
          "How much is said: 1 errors, 2 warnings, 3 progress (3)")
      ->type_name("LEVEL")
      ->expected(0, 1);
  command->callback([action, &chosen] { chosen = action; });
  return command;
}

void addAddress(CLI::App& command, Options& options, bool isMany) {
  auto* positional =
      command.add_option("ADDRESS", options.addresses, "https://fuel.gazebosim.org/1.0/OWNER/models/NAME")
          ->type_name("");
  if (!isMany) positional->expected(0, 1);
  command.add_option("-u,--url", options.url, "The address, as 'ign fuel' takes it")->type_name("URL");
}

void addHeader(CLI::App& command, Options& options) {
  command.add_option("--header", options.headers, "Of the requests, as 'Private-Token: TOKEN'")
      ->type_name("TEXT")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void addOffline(CLI::App& command, Options& options) {
  command.add_flag("--offline", options.offline, "Ask nothing of the network, as with PONGSIM_OFFLINE=1");
}

void addJobs(CLI::App& command, Options& options) {
  command
      .add_option_function<std::string>(
          "-j,--jobs",
          [&options](const std::string& text) {
            std::size_t jobs = 0;
            const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), jobs);
            if (error != std::errc() || end != text.data() + text.size() || jobs < 1 || jobs > 16) {
              throw UsageError("option '-j' takes a number from 1 to 16, not '" + text + "'");
            }
            options.jobs = jobs;
          },
          "Downloads at once, 1 to 16 (4)")
      ->type_name("N");
}

void addActions(CLI::App& program, Options& options, Action& chosen) {
  const auto add = [&](const char* name, const char* help, Action action) {
    return addAction(program, name, help, action, options, chosen);
  };
  CLI::App* list = add("list", "List the models or worlds of a server, or of the cache", fuel::list);
  list->add_option("-t,--type", options.type, "What to list")->type_name("model|world");
  list->add_option("-o,--owner", options.owner, "Those of one owner")->type_name("OWNER");
  list->add_option("-u,--url", options.url, "The server (those of the configuration, else https://fuel.gazebosim.org)")
      ->type_name("URL");
  list->add_flag("-r,--raw", options.raw, "Print addresses, one a line");
  list->add_flag("--cached", options.cached, "List what the cache has");
  addHeader(*list, options);
  addOffline(*list, options);

  CLI::App* about = add("info", "Tell of a model or world what its server and the cache know", info);
  addAddress(*about, options, false);
  about->add_flag("--cached", options.cached, "What the cache knows");
  addHeader(*about, options);
  addOffline(*about, options);

  CLI::App* load =
      add("download", "Bring models, worlds or collections into the cache, with all that they name", download);
  addAddress(*load, options, true);
  load->add_option("-t,--type", options.type, "Of a collection only these")->type_name("model|world");
  addJobs(*load, options);
  addHeader(*load, options);
  addOffline(*load, options);

  CLI::App* away = add("delete", "Delete a model or world from its server, or from the cache", remove);
  addAddress(*away, options, false);
  away->add_flag("--cached", options.cached, "From the cache");
  addHeader(*away, options);
  addOffline(*away, options);

  CLI::App* newer = add("update", "Bring the newest version of all that the cache has", update);
  newer->add_flag("--onlymodels", options.onlyModels, "Models only");
  newer->add_flag("--onlyworlds", options.onlyWorlds, "Worlds only")->excludes("--onlymodels");
  addJobs(*newer, options);
  addHeader(*newer, options);

  add("check", "Say what in the cache is broken", check);
  add("fetch", "", fetch)->group("");
}

/// What `ign fuel` does and this does not.
std::optional<std::string> insteadOf(const std::string& action) {
  if (action == "upload" || action == "edit")
    return "https://app.gazebosim.org does that, and 'ign fuel " + action + "'";
  if (action == "meta") return "'ign fuel meta' does that; model.config is read as it is";
  return std::nullopt;
}

int run(int argc, char** argv) {
  Options options;
  Action chosen = nullptr;
  CLI::App program("Models and worlds on Fuel servers, and the local cache of them, which Fortress shares",
                   "pongsim fuel");
  program.set_help_flag("-h,--help", "Print this and end");
  program.require_subcommand(0, 1);
  addActions(program, options, chosen);
  program.footer(
      "Examples:\n"
      "  pongsim fuel list -t model -o OpenRobotics\n"
      "  pongsim fuel download -u https://fuel.gazebosim.org/1.0/OpenRobotics/models/Ambulance\n"
      "  pongsim fuel check");
  if (argc > 1) {
    if (const auto instead = insteadOf(argv[1]))
      throw UsageError("'" + std::string(argv[1]) + "' is not done here", *instead);
  }
  const auto isNamed = [&](const CLI::App* action) { return argc > 1 && action->get_name() == argv[1]; };
  const bool isAction = std::ranges::any_of(program.get_subcommands([](const CLI::App*) { return true; }), isNamed);
  if (argc > 1 && argv[1][0] != '-' && !isAction) {
    throw UsageError("'" + std::string(argv[1]) + "' is no action",
                     "the actions are list, info, download, delete, update and check");
  }
  try {
    program.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    print(program.help());
    return kDone;
  } catch (const CLI::ParseError& error) {
    throw UsageError(error.what(), "pongsim fuel --help lists what there is");
  }
  if (chosen == nullptr) throw UsageError("no action given", "pongsim fuel --help lists what there is");
  checkHeaders(options.headers);
  if (options.offline) setenv("PONGSIM_OFFLINE", "1", 1);
  return chosen(options);
}

}  // namespace

int runCommand(int argc, char** argv) {
  handleSignals();
  try {
    return run(argc, argv);
  } catch (const UsageError& error) {
    sayError(error.what(), error.hint());
    return kWrongUsage;
  } catch (const Failure& failure) {
    sayError(failure.what(), failure.hint());
  } catch (const std::exception& failure) {
    sayError(failure.what());
  }
  return kFailed;
}

}  // namespace pongsim::fuel
