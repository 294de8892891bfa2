#include "base/own_program.hh"

#include <system_error>

#include "base/shared_library.hh"

namespace pongsim::base {

namespace fs = std::filesystem;

fs::path ownProgram(std::string_view name) {
  std::error_code ignored;
  // PREFIX/lib/libpongsim.so, PREFIX/lib/ARCHITECTURE/libpongsim.so, or a program with the library built in
  fs::path folder = ownLibraryFile().parent_path();
  for (int up = 0; up < 3 && folder.has_relative_path(); ++up) {
    folder = folder.parent_path();
    if (fs::path program = folder / "libexec/pongsim" / name; fs::exists(program, ignored)) return program;
  }
  return {};
}

}  // namespace pongsim::base
