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
/// @throws Failure if it is not a complete zip file, if an entry's name leads out of the folder, if an entry is a link
/// or special file, or if it exceeds the limits or the free disk space; PassingFailure if data is damaged. Files
/// unpacked until then are left.
void unpack(const std::filesystem::path& zip, const std::filesystem::path& folder, const ArchiveLimits& limits = {});

}  // namespace pongsim::fuel
