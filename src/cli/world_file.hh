#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "pongsim/diagnostic.hh"

namespace pongsim::cli {

/// Finds a world's file as Fortress does: as given, else in the resource folders that the environment names
/// (`assets::Places`), else among the worlds that came with this program.
/// @return Its path; `name` itself where there is no such file.
std::filesystem::path findWorldFile(const std::string& name);

/// As `findWorldFile`; the address of a world or model on a Fuel server is that of its SDF file in the local cache,
/// into which it is downloaded.
/// @return Nothing, and an error added, where a Fuel address leads to no file.
std::optional<std::filesystem::path> fetchWorldFile(const std::string& name, Diagnostics& diagnostics);

}  // namespace pongsim::cli
