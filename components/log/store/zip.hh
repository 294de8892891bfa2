#pragma once

#include <filesystem>

namespace pongsim::log {

/// Packs a folder with all its files into a zip file, in which their paths start with the folder's name.
/// @param zip Replaced if it exists.
/// @throws Failure if that fails; then there is no file.
void packFolder(const std::filesystem::path& folder, const std::filesystem::path& zip);

/// Unpacks a zip file with regular files and folders into an empty folder.
/// @throws Failure if it is not a zip file or is damaged, if a name leads out of the folder, or if the disk is full.
/// Files unpacked by then stay.
void unpackZip(const std::filesystem::path& zip, const std::filesystem::path& folder);

}  // namespace pongsim::log
