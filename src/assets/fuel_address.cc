#include "assets/fuel_address.hh"

#include <algorithm>
#include <charconv>
#include <system_error>
#include <vector>

#include "base/parse_number.hh"

namespace pongsim::assets {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kServers[] = {"fuel.ignitionrobotics.org", "fuel.gazebosim.org"};

/// @return What stands behind "https://" or "http://"; nothing where the text begins with neither.
std::optional<std::string_view> withoutScheme(std::string_view uri) {
  for (const std::string_view scheme : {std::string_view("https://"), std::string_view("http://")}) {
    if (uri.starts_with(scheme)) return uri.substr(scheme.size());
  }
  return std::nullopt;
}

std::string lowerCase(std::string_view text) {
  std::string lower(text);
  for (char& letter : lower) {
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  }
  return lower;
}

/// Turns "%20" into a space, and so on.
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

/// @return The parts between the slashes; nothing where one could lead out of the cache.
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

/// @return A version's number, from 1 up.
std::optional<int> versionFrom(std::string_view text) {
  const std::optional<long long> number = base::parseInteger(text);
  if (!number || *number < 1 || *number > 1'000'000) return std::nullopt;
  return static_cast<int>(*number);
}

}  // namespace

bool isFuelAddress(std::string_view uri) {
  const std::optional<std::string_view> rest = withoutScheme(uri);
  return rest && std::ranges::find(kServers, lowerCase(rest->substr(0, rest->find('/')))) != std::end(kServers);
}

std::optional<FuelAddress> parseFuelAddress(std::string_view uri) {
  if (!isFuelAddress(uri)) return std::nullopt;
  const auto parts = partsOf(*withoutScheme(uri));
  // HOST / 1.0 / OWNER / models / NAME [ / VERSION [ / files / PATH ] ]
  if (!parts || parts->size() < 5 || (*parts)[1] != "1.0" || (*parts)[3] != "models") return std::nullopt;
  FuelAddress address{lowerCase((*parts)[0]), (*parts)[2], (*parts)[4], {}, {}};
  std::size_t next = 5;
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

fs::path cacheFolder(const FuelAddress& address, std::string_view host, const fs::path& cache) {
  return cache / host / lowerCase(address.owner) / "models" / lowerCase(address.model);
}

std::optional<fs::path> newestVersion(const fs::path& folder) {
  int newest = 0;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    std::error_code ignored;
    const std::optional<int> version = versionFrom(entry->path().filename().string());
    if (version && entry->is_directory(ignored)) newest = std::max(newest, *version);
  }
  if (newest == 0) return std::nullopt;
  return folder / std::to_string(newest);
}

}  // namespace pongsim::assets
