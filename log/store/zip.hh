#pragma once

#include <filesystem>

namespace pongsim::log {

/// Packs a folder with all files in it into a zip file, in which its own name stands in front of theirs.
/// @param zip Replaced where it is there.
/// @throws Failure where it can't; then there is no file.
void packFolder(const std::filesystem::path& folder, const std::filesystem::path& zip);

/// Unpacks a zip file into an empty folder: plain files and folders.
/// @throws Failure where it is no zip file or damaged, where a name leads out of the folder, or the disk has no room.
/// What has been unpacked by then stays.
void unpackZip(const std::filesystem::path& zip, const std::filesystem::path& folder);

}  // namespace pongsim::log
