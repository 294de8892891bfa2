#include "cli/world_file.hh"

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <system_error>
#include <vector>

namespace pongsim::cli {

namespace {

namespace fs = std::filesystem;

void addFolders(const char* variable, std::vector<fs::path>& folders) {
  const char* const value = std::getenv(variable);
  std::string_view rest = value == nullptr ? "" : value;
  while (!rest.empty()) {
    const std::string_view folder = rest.substr(0, rest.find(':'));
    if (!folder.empty()) folders.emplace_back(folder);
    rest.remove_prefix(std::min(folder.size() + 1, rest.size()));
  }
}

}  // namespace

fs::path findWorldFile(const std::string& name) {
  std::error_code error;
  const fs::path given(name);
  if (given.empty() || given.is_absolute() || fs::exists(given, error)) return given;

  std::vector<fs::path> folders;
  addFolders("IGN_GAZEBO_RESOURCE_PATH", folders);
  addFolders("GZ_SIM_RESOURCE_PATH", folders);
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (!error) folders.push_back(program.parent_path().parent_path() / "share/pongsim/worlds");
  for (const fs::path& folder : folders) {
    if (fs::is_regular_file(folder / given, error)) return folder / given;
  }
  return given;
}

}  // namespace pongsim::cli
