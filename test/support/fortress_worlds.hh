#pragma once

#include <filesystem>
#include <optional>

namespace pongsim::test {

/// @return The project's root folder.
std::filesystem::path projectFolder();

/// @return The folder of Fortress's own worlds: what the environment variable PONGSIM_FORTRESS_WORLDS says, else
/// ../shared/fortress from the project's root; nothing where there is no such folder (skip the test then).
std::optional<std::filesystem::path> fortressWorlds();

/// @return The folder of data recorded with Fortress, beside that of its worlds; nothing where there is none.
std::optional<std::filesystem::path> goldenData();

}  // namespace pongsim::test
