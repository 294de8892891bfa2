// Arbitrary bytes as the zip file of a recording. Unpacking must end with files below the folder, or with a reason.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>

#include "fuzz/require.hh"
#include "log/store/failure.hh"
#include "log/store/zip.hh"
#include "support/temp_folder.hh"

namespace fs = std::filesystem;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace pongsim;
  static const test::TempFolder folder;
  const fs::path file = folder.write("a.zip", std::string_view(reinterpret_cast<const char*>(data), size));
  const fs::path out = folder.path() / "around" / "out";
  fs::create_directories(out);
  try {
    log::unpackZip(file, out, {.files = 100, .ratio = 20, .free = 1 << 20});
  } catch (const log::Failure& why) {
    fuzz::require(why.what()[0] != '\0');
  }
  // nothing is beside it
  fuzz::require(std::distance(fs::directory_iterator(folder.path()), {}) == 2);
  fuzz::require(std::distance(fs::directory_iterator(out.parent_path()), {}) == 1);
  fs::remove_all(out);
  return 0;
}
