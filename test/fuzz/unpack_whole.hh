#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <string_view>

#include "fuzz/require.hh"
#include "support/temp_folder.hh"

namespace pongsim::fuzz {

/// Unpacks arbitrary bytes as a zip file. All entries must be files or folders below the folder, or there must be a
/// `Failure` with a reason.
/// @param unpack Called with the zip file and the folder.
template <class Failure, class Unpack>
int unpackWhole(const std::uint8_t* data, std::size_t size, const Unpack& unpack) {
  namespace fs = std::filesystem;
  static const test::TempFolder folder;
  const fs::path file = folder.write("a.zip", std::string_view(reinterpret_cast<const char*>(data), size));
  const fs::path out = folder.path() / "around" / "out";
  fs::create_directories(out);
  try {
    unpack(file, out);
  } catch (const Failure& why) {
    require(why.what()[0] != '\0');
  }
  // nothing was created beside the folder, and no entry is a link
  require(std::distance(fs::directory_iterator(folder.path()), {}) == 2);
  require(std::distance(fs::directory_iterator(out.parent_path()), {}) == 1);
  for (const fs::directory_entry& each : fs::recursive_directory_iterator(out)) require(!each.is_symlink());
  fs::remove_all(out);
  return 0;
}

}  // namespace pongsim::fuzz
