#include "plugin/inspection.hh"

#include <algorithm>
#include <exception>
#include <set>
#include <system_error>
#include <utility>

#include "base/report/crash_report.hh"
#include "plugin/system_name.hh"

namespace pongsim::plugin {

std::variant<Inspection, std::string> Inspection::of(const std::filesystem::path& file) {
  const std::string name = "the plugin " + file.string();
  const base::RunningPart running(name.c_str(), "while it was inspected");
  auto opened = Library::open(file);
  if (auto* reason = std::get_if<std::string>(&opened)) return std::move(*reason);
  Inspection inspection(std::get<std::unique_ptr<Library>>(std::move(opened)));
  for (const SystemEntry& entry : inspection.library_->systems()) {
    try {
      Class& found = inspection.classes_.emplace_back();
      found.names.assign(entry.names.begin(), entry.names.end());
      found.system.reset(entry.create());
      found.system->declare(found.declaration);
    } catch (const std::exception& error) {
      return "its class " + inspection.classes_.back().names.front() + " can't be instantiated: " + error.what();
    }
  }
  return inspection;
}

Inspection::Inspection(std::unique_ptr<Library> library) : library_(std::move(library)) {}

std::optional<std::filesystem::path> findLibrary(const std::vector<std::filesystem::path>& searchPath,
                                                 std::string_view filename) {
  if (filename.find('/') != std::string_view::npos) return std::nullopt;
  const std::string name = systemName(filename);
  for (const std::filesystem::path& folder : searchPath) {
    for (const std::string& candidate :
         {"libpongsim-" + name + "-system.so", "lib" + name + ".so", name + ".so", std::string(filename)}) {
      std::error_code ignored;
      if (std::filesystem::is_regular_file(folder / candidate, ignored)) return folder / candidate;
    }
  }
  return std::nullopt;
}

std::vector<std::filesystem::path> librariesIn(const std::vector<std::filesystem::path>& searchPath) {
  std::vector<std::filesystem::path> all;
  std::set<std::string> names;
  for (const std::filesystem::path& folder : searchPath) {
    std::vector<std::filesystem::path> found;
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
      if (entry.path().extension() == ".so") found.push_back(entry.path());
    }
    std::ranges::sort(found);
    for (const std::filesystem::path& file : found) {
      if (names.insert(systemName(file.filename().string())).second) all.push_back(file);
    }
  }
  return all;
}

std::vector<std::string> systemsIn(const std::vector<std::filesystem::path>& searchPath) {
  std::vector<std::string> names;
  for (const std::filesystem::path& file : librariesIn(searchPath)) {
    names.push_back(systemName(file.filename().string()));
  }
  return names;
}

}  // namespace pongsim::plugin
