#include "fuel/settings.hh"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cstdlib>
#include <system_error>

#include "fuel/failure.hh"
#include "fuel/http.hh"
#include "pongsim/program/gazebo_variable.hh"

namespace pongsim::fuel {

namespace fs = std::filesystem;

namespace {

std::string hostOfServer(const Server& server) { return server.url.substr(server.url.find("://") + 3); }

/// Throws a Failure with the position in the file, FILE:LINE:COLUMN.
[[noreturn]] void fail(const fs::path& file, const YAML::Mark& mark, const std::string& message,
                       std::string hint = {}) {
  std::string place = file.string();
  if (mark.line >= 0) place += ":" + std::to_string(mark.line + 1) + ":" + std::to_string(mark.column + 1);
  throw Failure(place + ": " + message, std::move(hint));
}

std::string textOf(const YAML::Node& node, const std::string& name, const fs::path& file) {
  if (!node.IsScalar() || node.Scalar().empty()) fail(file, node.Mark(), "'" + name + "' must be a string");
  return node.Scalar();
}

Server readServer(const YAML::Node& node, const fs::path& file, std::vector<std::string>& warnings) {
  if (!node.IsMap()) fail(file, node.Mark(), "a server must be a map with 'url'", "write - url: https://HOST");
  Server server;
  for (const auto& entry : node) {
    const std::string key = entry.first.Scalar();
    if (key == "url") {
      server.url = textOf(entry.second, key, file);
    } else if (key == "private-token") {
      server.token = textOf(entry.second, key, file);
    } else if (key != "name") {
      warnings.push_back(file.string() + ":" + std::to_string(entry.first.Mark().line + 1) + ": '" + key +
                         "' of a server is unknown: use url, name and private-token");
    }
  }
  while (server.url.ends_with('/')) server.url.pop_back();
  if (server.url.empty()) fail(file, node.Mark(), "a server has no 'url'", "write - url: https://HOST");
  const bool isWeb = server.url.starts_with("https://") || server.url.starts_with("http://");
  if (!isWeb || originOf(server.url).size() != server.url.size() || server.url.ends_with("://")) {
    fail(file, node.Mark(), "'" + server.url + "' is not the address of a server",
         "write https://HOST or https://HOST:PORT");
  }
  if (server.token.find_first_of("\r\n") != std::string::npos)
    fail(file, node.Mark(), "'private-token' contains a line break");
  server.url = originOf(server.url);
  return server;
}

/// Adds a server of the file: it replaces a built-in one with the same address, and may have a token.
void add(const Server& server, std::vector<Server>& servers) {
  const auto same = std::ranges::find(servers, hostOfServer(server), hostOfServer);
  if (same == servers.end()) {
    servers.push_back(server);
  } else {
    *same = server;
  }
}

/// @return The configuration of `ign fuel`, else that of `gz fuel`; empty if there is neither.
fs::path usualFile() {
  const char* home = std::getenv("HOME");
  if (home == nullptr || *home == '\0') return {};
  for (const char* const name : {".ignition/fuel/config.yaml", ".gz/fuel/config.yaml"}) {
    std::error_code ignored;
    if (fs::path file = fs::path(home) / name; fs::exists(file, ignored)) return file;
  }
  return {};
}

void readFile(const fs::path& file, bool isNamed, Settings& settings, std::vector<std::string>& warnings) {
  YAML::Node root;
  try {
    root = YAML::LoadFile(file.string());
  } catch (const YAML::BadFile&) {
    throw Failure("the configuration '" + file.string() + "' can't be read");
  } catch (const YAML::Exception& error) {
    fail(file, error.mark, error.msg);
  }
  if (root.IsNull()) return;
  if (!root.IsMap()) fail(file, root.Mark(), "this must be a map with 'servers' and 'cache'");
  for (const auto& entry : root) {
    const std::string key = entry.first.Scalar();
    if (key == "servers") {
      if (!entry.second.IsSequence() && !entry.second.IsNull())
        fail(file, entry.second.Mark(), "'servers' is not a list");
      for (const YAML::Node& each : entry.second) settings.listed.push_back(readServer(each, file, warnings));
    } else if (key == "cache") {
      if (!entry.second.IsMap() || !entry.second["path"]) fail(file, entry.first.Mark(), "'cache' has no 'path'");
      const fs::path path = textOf(entry.second["path"], "path", file);
      if (!gazebo::kFuelCachePath.value().empty()) {
        warnings.push_back(file.string() +
                           ": the path of the cache is ignored: IGN_FUEL_CACHE_PATH or "
                           "GZ_FUEL_CACHE_PATH is set");
      } else if (!isNamed) {
        warnings.push_back(file.string() + ": the path of the cache is ignored; set IGN_FUEL_CACHE_PATH instead");
      } else {
        settings.cache = path;
      }
    } else {
      warnings.push_back(file.string() + ":" + std::to_string(entry.first.Mark().line + 1) + ": '" + key +
                         "' is unknown: use servers and cache");
    }
  }
}

}  // namespace

Settings readSettings(const std::optional<fs::path>& file, std::vector<std::string>& warnings) {
  Settings settings;
  settings.cache = fuelCacheFolder();
  settings.servers = {{"https://fuel.gazebosim.org"}, {"https://fuel.ignitionrobotics.org"}};
  const fs::path usual = usualFile();
  if (file) {
    readFile(*file, true, settings, warnings);
  } else if (!usual.empty()) {
    readFile(usual, false, settings, warnings);
  }
  for (const Server& server : settings.listed) add(server, settings.servers);
  if (settings.listed.empty()) settings.listed.push_back(settings.servers.front());
  if (settings.cache.empty()) throw Failure("there is no folder for downloads", "set HOME or IGN_FUEL_CACHE_PATH");
  return settings;
}

const Server& serverOf(const FuelAddress& address, const Settings& settings) {
  const auto found = std::ranges::find(settings.servers, address.host, hostOfServer);
  if (found == settings.servers.end()) {
    throw Failure(
        "the server " + address.host + " is not configured",
        "add it to ~/.ignition/fuel/config.yaml, under servers: - url: " + address.scheme + "://" + address.host);
  }
  return *found;
}

}  // namespace pongsim::fuel
