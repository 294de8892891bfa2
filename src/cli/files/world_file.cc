#include "cli/files/world_file.hh"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <memory>
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

/// @return Where a text goes on after a word and `sign`, between which there are at most spaces and a colon; npos if
/// they are not there from `at` on.
std::size_t after(const std::string& word, char sign, const std::string& text, std::size_t at) {
  for (at = text.find(word, at); at != std::string::npos; at = text.find(word, at + 1)) {
    const bool isWhole =
        at == 0 || (std::isalnum(static_cast<unsigned char>(text[at - 1])) == 0 && text[at - 1] != '_');
    const std::size_t next = text.find_first_not_of(" \t\r\n:", at + word.size());
    if (isWhole && next != std::string::npos && text[next] == sign) return next + 1;
  }
  return std::string::npos;
}

/// @return The file that the text of a world's metadata names, as in `world { file: "x.sdf" }`; empty if there is none
/// without folders.
std::string fileIn(const std::string& metadata) {
  const std::size_t inside = after("world", '{', metadata, 0);
  const std::size_t begin = after("file", '"', metadata, inside);
  if (begin == std::string::npos) return {};
  const std::string name = metadata.substr(begin, metadata.find('"', begin) - begin);
  return name.find('/') == std::string::npos ? name : std::string();
}

/// @return The file named in a world's metadata.pbtxt, else the first SDF file in its folder by name; nothing if there
/// is none.
std::optional<fs::path> worldFileIn(const fs::path& folder) {
  std::ifstream stream(folder / "metadata.pbtxt");
  const std::string metadata{std::istreambuf_iterator<char>(stream), {}};
  const std::string named = fileIn(metadata);
  std::error_code error;
  if (!named.empty() && fs::is_regular_file(folder / named, error)) return folder / named;
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
