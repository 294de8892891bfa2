#pragma once

#include <cstdint>
#include <filesystem>

namespace pongsim::fuel {

/// What an archive may hold.
struct ArchiveLimits {
  std::uint64_t files = 100'000;
  std::uint64_t bytes = std::uint64_t{8} << 30U;
  /// Unpacked bytes for each packed one, beyond `free` bytes: text packs to a twentieth, a bomb to a thousandth.
  std::uint64_t ratio = 200;
  std::uint64_t free = std::uint64_t{64} << 20U;
};

/// Unpacks a zip file into an empty folder: plain files and folders, with the rights that new ones have.
/// @throws Failure where it is no whole zip file, where a name leads out of the folder, something is a link or other
/// than a file or folder, it holds more than the limits or than the disk takes; PassingFailure where the bytes are
/// damaged. What has been unpacked by then stays.
void unpack(const std::filesystem::path& zip, const std::filesystem::path& folder, const ArchiveLimits& limits = {});

}  // namespace pongsim::fuel
