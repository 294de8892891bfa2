#include "cli/own_folder.hh"

#include <system_error>

namespace pongsim::cli {

std::filesystem::path ownFolder() {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  return error ? std::filesystem::path() : program.parent_path().parent_path() / "share/pongsim";
}

}  // namespace pongsim::cli
