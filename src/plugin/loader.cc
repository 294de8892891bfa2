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
#include "pongsim/program/gazebo_variable.hh"

namespace pongsim::plugin {

namespace {

constexpr const char* kNoPlugin = "__default__";

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

constexpr const char* kLeftOut = ": it is left out";

/// Reports a plugin that can't be had.
/// @param what What is wrong with it.
void report(const description::Plugin& plugin, Loader::Need need, const std::string& what, const std::string& hint,
            Diagnostics& diagnostics) {
  const std::string message = "plugin '" + plugin.filename + "' " + what;
  if (need == Loader::Need::kRequired) {
    diagnostics.error(plugin.sdf.position, message, hint);
  } else {
    diagnostics.warning(plugin.sdf.position, message + kLeftOut, hint);
  }
}

std::string pathHint(Loader::Paths paths) {
  const std::string leave = paths == Loader::Paths::kNever
                                ? "only the world that a run starts with may name paths, if it is not from a server; "
                                : "if you trust this world, run it with --allow-plugin-paths; or ";
  return leave + "name the library alone, and its folder in PONGSIM_PLUGIN_PATH";
}

/// @return "plugin 'a' was not found: it is left out", or "2 plugins were not found: they are left out: 'a' (line 4),
/// 'b' (line 8)".
std::string sumUp(const std::vector<description::Plugin>& plugins, const std::string& one, const std::string& several) {
  if (plugins.size() == 1) return "plugin '" + plugins.front().filename + "' " + one + kLeftOut;
  std::string text = std::to_string(plugins.size()) + " plugins " + several + ": they are left out: ";
  for (const description::Plugin& plugin : plugins) {
    if (&plugin != &plugins.front()) text += ", ";
    text += "'" + plugin.filename + "'";
    const SourcePosition& position = plugin.sdf.position;
    if (position.line > 0) text += " (line " + std::to_string(position.line) + ")";
  }
  return text;
}

}  // namespace

std::vector<std::filesystem::path> defaultSearchPath() {
  std::vector<std::filesystem::path> folders;
  appendFolders("PONGSIM_PLUGIN_PATH", folders);
  appendFolders(gazebo::kSystemPluginPath.fortress, folders);
  appendFolders(gazebo::kSystemPluginPath.later, folders);
  const std::filesystem::path self = base::ownLibraryFile();
  if (!self.empty()) folders.push_back(self.parent_path() / PONGSIM_PLUGIN_SUBDIRECTORY);
  return folders;
}

Loader::Loader(std::vector<std::filesystem::path> searchPath) : searchPath_(std::move(searchPath)) {}

std::unique_ptr<System> Loader::load(const description::Plugin& plugin, Paths paths, Need need,
                                     Diagnostics& diagnostics) {
  // libsdformat's default for a plugin without a name or filename, which some tools write out
  if (plugin.filename == kNoPlugin || plugin.className == kNoPlugin) return nullptr;
  const std::string name = systemName(plugin.filename);
  const Library* found = library(name, plugin, paths, need, diagnostics);
  if (found == nullptr) return nullptr;
  const SystemEntry* entry = findEntry(*found, plugin.className);
  if (entry != nullptr) return std::unique_ptr<System>(entry->create());

  std::vector<std::string_view> known;
  for (const SystemEntry& candidate : found->systems()) {
    known.insert(known.end(), candidate.names.begin(), candidate.names.end());
  }
  std::string hint = base::didYouMean(plugin.className, known);
  if (hint.empty() && !known.empty()) hint = "it has " + std::string(known.front());
  report(plugin, need, "has no class '" + plugin.className + "'", hint, diagnostics);
  return nullptr;
}

const Library* Loader::library(const std::string& name, const description::Plugin& plugin, Paths paths, Need need,
                               Diagnostics& diagnostics) {
  const bool isPath = plugin.filename.find('/') != std::string::npos;
  if (isPath && paths != Paths::kAllowed) {
    report(plugin, need, "is a path, which is not allowed here", pathHint(paths), diagnostics);
    return nullptr;
  }
  const auto known = libraries_.find(name);
  if (known != libraries_.end()) return known->second.get();
  const std::optional<std::filesystem::path> file =
      isPath ? existing(plugin.filename) : findLibrary(searchPath_, plugin.filename);
  if (!file) {
    noteNotFound(name, plugin, need, diagnostics);
    return nullptr;
  }
  auto opened = Library::open(*file);
  if (auto* library = std::get_if<std::unique_ptr<Library>>(&opened)) {
    return libraries_.emplace(name, std::move(*library)).first->second.get();
  }
  report(plugin, need, "can't be loaded from " + file->string() + ": " + std::get<std::string>(opened), {},
         diagnostics);
  return nullptr;
}

std::string Loader::lookedIn() const {
  std::string text = "looked in";
  for (const std::filesystem::path& folder : searchPath_) text += " " + folder.string();
  return text + "; PONGSIM_PLUGIN_PATH adds folders";
}

void Loader::noteNotFound(const std::string& name, const description::Plugin& plugin, Need need,
                          Diagnostics& diagnostics) {
  if (need == Need::kOptional) {
    if (std::ranges::find(missed_, name) != missed_.end()) return;
    missed_.push_back(name);
  }
  const std::string package(packageOf(name));
  if (!package.empty()) {
    return report(plugin, need, "is not installed", "the package " + package + " has it: apt-get install " + package,
                  diagnostics);
  }
  if (isOfGazebo(name)) return report(plugin, need, "is a system of Gazebo that is not supported yet", {}, diagnostics);
  if (isForeignPlugin(name) && need == Need::kOptional) return foreign_.push_back(plugin);
  const std::vector<std::string> available = systemsIn(searchPath_);
  std::vector<std::string_view> words(available.begin(), available.end());
  words.insert(words.end(), fortressSystems().begin(), fortressSystems().end());
  for (const LaterSystem& system : laterSystems()) words.push_back(system.name);
  const std::string meant = base::didYouMean(name, words);
  if (meant.empty() && need == Need::kOptional) return unknown_.push_back(plugin);
  report(plugin, need, "was not found", meant.empty() ? lookedIn() : meant, diagnostics);
}

void Loader::reportLimit(const CoreSystem& system, const SourcePosition& position, Diagnostics& diagnostics) {
  if (system.limit.empty() || !limited_.insert(system.name).second) return;
  diagnostics.warning(position, system.name + " has no effect: " + system.limit);
}

void Loader::reportMissing(Diagnostics& diagnostics) {
  if (!foreign_.empty()) {
    diagnostics.warning(foreign_.front().sdf.position,
                        sumUp(foreign_, "is of Gazebo Classic or ROS", "are of Gazebo Classic or ROS"),
                        "Fortress can't load " + std::string(foreign_.size() == 1 ? "it" : "them") + " either");
  }
  if (!unknown_.empty()) {
    diagnostics.warning(unknown_.front().sdf.position, sumUp(unknown_, "was not found", "were not found"), lookedIn());
  }
  foreign_.clear();
  unknown_.clear();
}

}  // namespace pongsim::plugin
