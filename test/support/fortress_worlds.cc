#include "support/fortress_worlds.hh"

#include <cstdlib>

namespace pongsim::test {

namespace {

std::optional<std::filesystem::path> ifFolder(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return path;
  return std::nullopt;
}

}  // namespace

std::filesystem::path projectFolder() { return PONGSIM_SOURCE_DIR; }

std::optional<std::filesystem::path> fortressWorlds() {
  if (const char* folder = std::getenv("PONGSIM_FORTRESS_WORLDS")) return ifFolder(folder);
  return ifFolder(projectFolder().parent_path() / "shared" / "fortress");
}

std::optional<std::filesystem::path> goldenData() {
  return ifFolder(fortressWorlds().value_or(projectFolder().parent_path() / "shared" / "fortress").parent_path() /
                  "golden");
}

}  // namespace pongsim::test
