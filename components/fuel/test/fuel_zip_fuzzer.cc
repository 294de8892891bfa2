// Unpacks arbitrary bytes as a zip file. All files must be below the folder, or a Failure must be thrown.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>

#include "fuel/archive.hh"
#include "fuel/failure.hh"
#include "fuzz/require.hh"
#include "support/temp_folder.hh"

namespace fs = std::filesystem;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace pongsim;
  static const test::TempFolder folder;
  const fs::path file = folder.write("a.zip", std::string_view(reinterpret_cast<const char*>(data), size));
  const fs::path out = folder.path() / "around" / "out";
  fs::create_directories(out);
  try {
    fuel::unpack(file, out, {.files = 100, .bytes = 4 << 20, .ratio = 20, .free = 1 << 20});
  } catch (const fuel::Failure& why) {
    fuzz::require(why.what()[0] != '\0');
  }
  // nothing was created beside the folder, and no entry is a link
  fuzz::require(std::distance(fs::directory_iterator(folder.path()), {}) == 2);
  fuzz::require(std::distance(fs::directory_iterator(out.parent_path()), {}) == 1);
  for (const fs::directory_entry& each : fs::recursive_directory_iterator(out)) fuzz::require(!each.is_symlink());
  fs::remove_all(out);
  return 0;
}
