// Arbitrary bytes as the zip file of a recording. Unpacking must end with files below the folder, or with a reason.

#include <cstddef>
#include <cstdint>
#include <filesystem>

#include "fuzz/unpack_whole.hh"
#include "log/store/failure.hh"
#include "log/store/zip.hh"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using std::filesystem::path;
  return pongsim::fuzz::unpackWhole<pongsim::log::Failure>(data, size, [](const path& file, const path& folder) {
    pongsim::log::unpackZip(file, folder, {.files = 100, .ratio = 20, .free = 1 << 20});
  });
}
