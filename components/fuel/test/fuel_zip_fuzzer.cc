// Arbitrary bytes as the zip file of a model. Unpacking must end with files below the folder, or with a reason.

#include <cstddef>
#include <cstdint>
#include <filesystem>

#include "fuel/archive.hh"
#include "fuel/failure.hh"
#include "fuzz/unpack_whole.hh"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using std::filesystem::path;
  return pongsim::fuzz::unpackWhole<pongsim::fuel::Failure>(data, size, [](const path& file, const path& folder) {
    pongsim::fuel::unpack(file, folder, {.files = 100, .bytes = 4 << 20, .ratio = 20, .free = 1 << 20});
  });
}
