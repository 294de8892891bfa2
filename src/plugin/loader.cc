#include "plugin/loader.hh"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/nearest_word.hh"
#include "base/shared_library.hh"
#include "plugin/fortress_systems.hh"
#include "plugin/inspection.hh"
#include "plugin/system_name.hh"

namespace pongsim::plugin {

namespace {

void appendFolders(const char* variable, std::vector<std::filesystem::path>& folders) {
  const char* value = std::getenv(variable);
  if (value == nullptr) return;
  std::string_view rest = value;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(':'), rest.size());
    if (end > 0) folders.emplace_back(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
}

/// @return The entry of this class; the first one if no class is named; null if there is none.
const SystemEntry* findEntry(const Library& library, const std::string& className) {
  for (const SystemEntry& entry : library.systems()) {
    if (className.empty() || std::ranges::find(entry.names, std::string_view(className)) != entry.names.end()) {
      return &entry;
    }
  }
  return nullptr;
}

/// @return The file, if it is there.
std::optional<std::filesystem::path> existing(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) return std::nullopt;
  return file;
}

void reportPath(const description::Plugin& plugin, Loader::Paths paths, Diagnostics& diagnostics) {
  const std::string leave = paths == Loader::Paths::kNever
                                ? "only the world that a run starts with may name paths, if it is not from a server; "
                                : "if you trust this world, run it with --allow-plugin-paths; or ";
  diagnostics.error(plugin.sdf.position, "plugin '" + plugin.filename + "' is a path, which is not allowed here",
                    leave + "name the library alone, and its folder in PONGSIM_PLUGIN_PATH");
}

}  // namespace

std::vector<std::filesystem::path> defaultSearchPath() {
  std::vector<std::filesystem::path> folders;
  appendFolders("PONGSIM_PLUGIN_PATH", folders);
  appendFolders("IGN_GAZEBO_SYSTEM_PLUGIN_PATH", folders);
  appendFolders("GZ_SIM_SYSTEM_PLUGIN_PATH", folders);
  const std::filesystem::path self = base::ownLibraryFile();
  if (!self.empty()) folders.push_back(self.parent_path() / PONGSIM_PLUGIN_SUBDIRECTORY);
  return folders;
}

Loader::Loader(std::vector<std::filesystem::path> searchPath) : searchPath_(std::move(searchPath)) {}

std::unique_ptr<System> Loader::load(const description::Plugin& plugin, Paths paths, Diagnostics& diagnostics) {
  const std::string name = systemName(plugin.filename);
  const Library* found = library(name, plugin, paths, diagnostics);
  if (found == nullptr) return nullptr;
  const SystemEntry* entry = findEntry(*found, plugin.className);
  if (entry != nullptr) return std::unique_ptr<System>(entry->create());

  std::vector<std::string_view> known;
  for (const SystemEntry& candidate : found->systems()) {
    known.insert(known.end(), candidate.names.begin(), candidate.names.end());
  }
  std::string hint = base::didYouMean(plugin.className, known);
  if (hint.empty() && !known.empty()) hint = "it has " + std::string(known.front());
  diagnostics.error(plugin.sdf.position, "plugin '" + plugin.filename + "' has no class '" + plugin.className + "'",
                    hint);
  return nullptr;
}

const Library* Loader::library(const std::string& name, const description::Plugin& plugin, Paths paths,
                               Diagnostics& diagnostics) {
  const bool isPath = plugin.filename.find('/') != std::string::npos;
  if (isPath && paths != Paths::kAllowed) {
    reportPath(plugin, paths, diagnostics);
    return nullptr;
  }
  const auto known = libraries_.find(name);
  if (known != libraries_.end()) return known->second.get();
  const std::optional<std::filesystem::path> file =
      isPath ? existing(plugin.filename) : findLibrary(searchPath_, plugin.filename);
  if (!file) {
    reportNotFound(name, plugin, diagnostics);
    return nullptr;
  }
  auto opened = Library::open(*file);
  if (auto* library = std::get_if<std::unique_ptr<Library>>(&opened)) {
    return libraries_.emplace(name, std::move(*library)).first->second.get();
  }
  diagnostics.error(plugin.sdf.position, "plugin '" + plugin.filename + "' can't be loaded from " + file->string() +
                                             ": " + std::get<std::string>(opened));
  return nullptr;
}

void Loader::reportNotFound(const std::string& name, const description::Plugin& plugin, Diagnostics& diagnostics) {
  const std::string package(packageOf(name));
  const std::string install = "the package " + package + " has it: apt-get install " + package;
  const bool isOfFortress = std::ranges::find(fortressSystems(), std::string_view(name)) != fortressSystems().end();
  if (isOfFortress || isForeignPlugin(name)) {
    if (std::ranges::find(missed_, name) != missed_.end()) return;
    missed_.push_back(name);
    if (!package.empty()) {
      diagnostics.warning(plugin.sdf.position, "plugin '" + plugin.filename + "' is not installed: it is left out",
                          install);
    } else if (isOfFortress) {
      diagnostics.warning(plugin.sdf.position,
                          "the system '" + name + "' of Gazebo is not supported yet: it is left out");
    } else {
      diagnostics.warning(plugin.sdf.position,
                          "plugin '" + plugin.filename + "' is a plugin of Gazebo Classic or ROS: it is left out",
                          "Fortress can't load it either");
    }
    return;
  }
  const std::vector<std::string> available = systemsIn(searchPath_);
  std::vector<std::string_view> words(available.begin(), available.end());
  words.insert(words.end(), fortressSystems().begin(), fortressSystems().end());
  std::string hint = package.empty() ? base::didYouMean(name, words) : install;
  if (hint.empty()) {
    hint = "looked in";
    for (const std::filesystem::path& folder : searchPath_) hint += " " + folder.string();
    hint += "; PONGSIM_PLUGIN_PATH adds folders";
  }
  diagnostics.error(plugin.sdf.position, "plugin '" + plugin.filename + "' was not found", hint);
}

}  // namespace pongsim::plugin
