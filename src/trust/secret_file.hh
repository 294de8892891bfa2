#pragma once

#include <filesystem>
#include <string>

namespace pongsim::trust {

/// @return The file's content.
/// @throws KeystoreError if it does not exist, is not a file or can't be read.
std::string contentsOf(const std::filesystem::path& file);

/// @throws KeystoreError if anybody but its owner can read the file, taking the parent folders into account.
void requireSecret(const std::filesystem::path& file);

}  // namespace pongsim::trust
