#pragma once

#include <filesystem>
#include <optional>

namespace pongsim::test {

/// @return The project's root folder.
std::filesystem::path projectFolder();

/// @return The folder of Fortress's own worlds: that in the environment variable PONGSIM_FORTRESS_WORLDS, else
/// ../shared/fortress relative to the project's root; nothing if it does not exist (skip the test then).
std::optional<std::filesystem::path> fortressWorlds();

/// @return The folder of data recorded with Fortress, beside that of its worlds; nothing if it does not exist.
std::optional<std::filesystem::path> goldenData();

}  // namespace pongsim::test
