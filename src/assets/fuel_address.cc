#include "pongsim/files/fuel_address.hh"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <system_error>
#include <vector>

#include "base/parse_number.hh"
#include "pongsim/program/gazebo_variable.hh"

namespace pongsim {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kOldServer = "fuel.ignitionrobotics.org", kNewServer = "fuel.gazebosim.org";
constexpr std::string_view kSchemes[] = {"https://", "http://"};

std::string lowerCase(std::string_view text) {
  std::string lower(text);
  for (char& letter : lower) {
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  }
  return lower;
}

/// Decodes "%20" to a space, and so on.
std::string decoded(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned char byte = 0;
    if (text[i] == '%' && i + 2 < text.size()) {
      const char* const end = text.data() + i + 3;
      if (std::from_chars(text.data() + i + 1, end, byte, 16).ptr == end) {
        plain += static_cast<char>(byte);
        i += 2;
        continue;
      }
    }
    plain += text[i];
  }
  return plain;
}

/// @return The parts between the slashes; nothing if one could lead out of the cache, such as "..".
std::optional<std::vector<std::string>> partsOf(std::string_view path) {
  std::vector<std::string> parts;
  while (!path.empty()) {
    const std::size_t end = std::min(path.find('/'), path.size());
    std::string part = decoded(path.substr(0, end));
    path.remove_prefix(std::min(end + 1, path.size()));
    if (part.empty() && path.empty()) break;
    if (part.empty() || part == "." || part == ".." || part.find_first_of(std::string_view("/\0", 2)) != part.npos) {
      return std::nullopt;
    }
    parts.push_back(std::move(part));
  }
  return parts;
}

/// @return The version number, at least 1.
std::optional<int> versionFrom(std::string_view text) {
  const std::optional<long long> number = base::parseInteger(text);
  if (!number || *number < 1 || *number > 1'000'000) return std::nullopt;
  return static_cast<int>(*number);
}

/// @return Whether a part is the version of a server's interface: "1.0".
bool isApiVersion(std::string_view text) {
  const std::size_t dot = text.find('.');
  const auto isNumber = [](std::string_view digits) {
    return !digits.empty() && std::ranges::all_of(digits, [](char each) { return each >= '0' && each <= '9'; });
  };
  return dot != text.npos && isNumber(text.substr(0, dot)) && isNumber(text.substr(dot + 1));
}

/// @return Whether it is a server's name or IP address, with or without a port.
bool isHost(std::string_view text) {
  return !text.empty() && text.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789.-:[]_") == text.npos &&
         text != "." && text != "..";
}

/// Encodes everything but letters, digits and "-._~" as "%20" and so on: RFC 3986, 2.1.
std::string encoded(std::string_view text) {
  std::string safe;
  for (const char each : text) {
    const bool isPlain = (each >= 'a' && each <= 'z') || (each >= 'A' && each <= 'Z') || (each >= '0' && each <= '9') ||
                         std::string_view("-._~").find(each) != std::string_view::npos;
    char code[4] = {each, 0};
    if (!isPlain) std::snprintf(code, sizeof code, "%%%02X", static_cast<unsigned>(static_cast<unsigned char>(each)));
    safe += code;
  }
  return safe;
}

std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value != nullptr ? value : "";
}

}  // namespace

std::string FuelAddress::url() const {
  return scheme + "://" + host + "/" + apiVersion + "/" + encoded(owner) + (isWorld ? "/worlds/" : "/models/") +
         encoded(name);
}

bool isFuelAddress(std::string_view uri) {
  return std::ranges::any_of(kSchemes, [&](std::string_view scheme) { return uri.starts_with(scheme); });
}

std::optional<FuelAddress> parseFuelAddress(std::string_view uri) {
  if (!isFuelAddress(uri)) return std::nullopt;
  const std::size_t mark = uri.find("://");
  const auto parts = partsOf(uri.substr(mark + 3));
  // HOST [ / 1.0 ] / OWNER / models|worlds / NAME [ / VERSION ] [ / files / PATH ]
  if (!parts || parts->size() < 4 || !isHost(lowerCase((*parts)[0]))) return std::nullopt;
  std::size_t next = 1;
  FuelAddress address{.scheme = std::string(uri.substr(0, mark)), .host = lowerCase((*parts)[0])};
  if (isApiVersion((*parts)[next])) address.apiVersion = (*parts)[next++];
  if (parts->size() < next + 3) return std::nullopt;
  address.owner = (*parts)[next++];
  const std::string& kind = (*parts)[next++];
  if (kind != "models" && kind != "worlds") return std::nullopt;
  address.isWorld = kind == "worlds";
  address.name = (*parts)[next++];
  if (next < parts->size() && (*parts)[next] != "files") {
    address.version = versionFrom((*parts)[next]);
    if (!address.version && (*parts)[next] != "tip") return std::nullopt;
    ++next;
  }
  if (next == parts->size()) return address;
  if ((*parts)[next] != "files") return std::nullopt;
  for (++next; next < parts->size(); ++next) address.file /= (*parts)[next];
  return address;
}

fs::path fuelCacheFolder() {
  if (const std::string cache = gazebo::kFuelCachePath.value(); !cache.empty()) return cache;
  const std::string home = variable("HOME");
  if (home.empty()) return {};
  const fs::path ofFortress = fs::path(home) / ".ignition" / "fuel", later = fs::path(home) / ".gz" / "fuel";
  std::error_code ignored;
  return !fs::exists(ofFortress, ignored) && fs::exists(later, ignored) ? later : ofFortress;
}

fs::path fuelFolder(const FuelAddress& address, const fs::path& cache) {
  return cache / address.host / lowerCase(address.owner) / (address.isWorld ? "worlds" : "models") /
         lowerCase(address.name);
}

bool isWholeFuelVersion(const fs::path& folder) {
  std::error_code ignored;
  const fs::path zip = folder.parent_path().filename().string() + ".zip";
  return fs::is_directory(folder, ignored) && !fs::exists(folder / zip, ignored);
}

std::optional<int> newestFuelVersion(const fs::path& folder) {
  int newest = 0;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const std::optional<int> version = versionFrom(entry->path().filename().string());
    if (version && *version > newest && isWholeFuelVersion(entry->path())) newest = *version;
  }
  return newest == 0 ? std::nullopt : std::optional(newest);
}

std::optional<fs::path> findInFuelCache(const FuelAddress& address, const fs::path& cache) {
  if (cache.empty()) return std::nullopt;
  for (const std::string& host : {address.host, otherFuelHost(address.host)}) {
    if (host.empty()) continue;
    FuelAddress there = address;
    there.host = host;
    const fs::path folder = fuelFolder(there, cache);
    const std::optional<int> version = address.version ? address.version : newestFuelVersion(folder);
    if (!version || !isWholeFuelVersion(folder / std::to_string(*version))) continue;
    const fs::path found = folder / std::to_string(*version) / address.file;
    std::error_code ignored;
    if (address.file.empty()) return folder / std::to_string(*version);
    if (fs::exists(found, ignored)) return found;
  }
  return std::nullopt;
}

std::string otherFuelHost(std::string_view host) {
  if (host == kOldServer) return std::string(kNewServer);
  return host == kNewServer ? std::string(kOldServer) : std::string();
}

bool isFuelOffline() {
  const std::string value = variable("PONGSIM_OFFLINE");
  return !value.empty() && value != "0";
}

}  // namespace pongsim
