#pragma once

#include <cstdint>
#include <filesystem>

namespace pongsim::log {

/// Packs a folder with all its files into a zip file, in which their paths start with the folder's name.
/// @param zip Replaced if it exists.
/// @throws Failure if that fails; then there is no file.
void packFolder(const std::filesystem::path& folder, const std::filesystem::path& zip);

/// Limits for a zip file.
struct ZipLimits {
  std::uint64_t files = 100'000;
  /// Unpacked bytes per packed byte, beyond `free` bytes: recordings compress by a factor of 5 to 50, zeros by 1,000.
  std::uint64_t ratio = 200;
  std::uint64_t free = std::uint64_t{64} << 20U;
};

/// Unpacks a zip file with regular files and folders into an empty folder.
/// @throws Failure if it is not a zip file or is damaged, if a name leads out of the folder, if it exceeds the limits
/// or its own claims, or if the disk is full. Files unpacked by then stay.
void unpackZip(const std::filesystem::path& zip, const std::filesystem::path& folder, const ZipLimits& limits = {});

}  // namespace pongsim::log
