#include "cli/world_file.hh"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <memory>
#include <regex>
#include <system_error>
#include <vector>

#include "assets/finder.hh"
#include "assets/places.hh"
#include "cli/own_folder.hh"
#include "pongsim/files/fuel_address.hh"
#include "sdf/includes/model_config.hh"

namespace pongsim::cli {

namespace fs = std::filesystem;

namespace {

/// @return The file named in a world's metadata.pbtxt, else the first SDF file in its folder by name; nothing if there
/// is none.
std::optional<fs::path> worldFileIn(const fs::path& folder) {
  std::ifstream stream(folder / "metadata.pbtxt");
  const std::string metadata{std::istreambuf_iterator<char>(stream), {}};
  std::smatch match;
  static const std::regex kFile("world\\s*:?\\s*\\{[^]*?\\bfile\\s*:\\s*\"([^\"/]+)\"");
  std::error_code error;
  if (std::regex_search(metadata, match, kFile) && fs::is_regular_file(folder / match[1].str(), error)) {
    return folder / match[1].str();
  }
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() == ".sdf" || entry.path().extension() == ".world") files.push_back(entry.path());
  }
  if (files.empty()) return std::nullopt;
  return *std::ranges::min_element(files);
}

}  // namespace

fs::path findWorldFile(const std::string& name) {
  std::error_code error;
  const fs::path given(name);
  if (given.empty() || given.is_absolute() || fs::exists(given, error)) return given;

  std::vector<fs::path> folders = assets::Places::fromEnvironment().folders;
  if (const fs::path own = ownFolder(); !own.empty()) folders.push_back(own / "worlds");
  for (const fs::path& folder : folders) {
    if (fs::is_regular_file(folder / given, error)) return folder / given;
  }
  return given;
}

std::optional<fs::path> fetchWorldFile(const std::string& name, Diagnostics& diagnostics) {
  if (!isFuelAddress(name)) return findWorldFile(name);
  const SourcePosition position{std::make_shared<const std::string>("command line"), 0, 0};
  const std::optional<fs::path> found = assets::finderFromEnvironment()(name, {}, position, diagnostics);
  std::error_code ignored;
  if (!found || !fs::is_directory(*found, ignored)) return found;
  if (fs::exists(*found / "model.config", ignored)) {
    const auto config = std::make_shared<const std::string>((*found / "model.config").string());
    return sdf::readModelConfig(*found / "model.config", config, diagnostics);
  }
  std::optional<fs::path> file = worldFileIn(*found);
  if (!file) diagnostics.error(position, "there is no SDF file in '" + found->string() + "'");
  return file;
}

}  // namespace pongsim::cli
