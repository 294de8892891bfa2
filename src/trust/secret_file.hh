#pragma once

#include <filesystem>
#include <string>

namespace pongsim::trust {

/// @return What stands in the file.
/// @throws KeystoreError where it is not there, is not a file or can't be read.
std::string contentsOf(const std::filesystem::path& file);

/// @throws KeystoreError where somebody other than its owner can read the file, with respect to the folders above it.
void requireSecret(const std::filesystem::path& file);

}  // namespace pongsim::trust
