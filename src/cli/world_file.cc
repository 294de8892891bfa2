#include "cli/world_file.hh"

#include <system_error>
#include <vector>

#include "assets/places.hh"
#include "cli/own_folder.hh"

namespace pongsim::cli {

namespace fs = std::filesystem;

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

}  // namespace pongsim::cli
