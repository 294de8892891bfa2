#pragma once

#include <cstdint>
#include <filesystem>

namespace pongsim::fuel {

/// Limits for an archive.
struct ArchiveLimits {
  std::uint64_t files = 100'000;
  std::uint64_t bytes = std::uint64_t{8} << 30U;
  /// Unpacked bytes per packed byte, beyond `free` bytes: text compresses by a factor of 20, a zip bomb by 1,000.
  std::uint64_t ratio = 200;
  std::uint64_t free = std::uint64_t{64} << 20U;
};

/// Unpacks a zip file into an empty folder: regular files and folders, with default permissions.
/// @throws Failure if it is not a complete zip file, if a name leads out of the folder, if an entry is a link or a
/// special file, or if it exceeds the limits or the disk; PassingFailure if the bytes are damaged. Files unpacked by
/// then stay.
void unpack(const std::filesystem::path& zip, const std::filesystem::path& folder, const ArchiveLimits& limits = {});

}  // namespace pongsim::fuel
