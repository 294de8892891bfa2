#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "pongsim/diagnostic.hh"

namespace pongsim::cli {

/// Finds a world's file as Fortress does: as given, else in the resource folders from the environment
/// (`assets::Places`), else among the worlds that came with this program.
/// @return Its path; `name` itself if there is no such file.
std::filesystem::path findWorldFile(const std::string& name);

/// Like `findWorldFile`; in addition, the address of a world or model on a Fuel server stands for its SDF file in the
/// local cache, which is downloaded if necessary.
/// @return Nothing, with an error, if a Fuel address leads to no file.
std::optional<std::filesystem::path> fetchWorldFile(const std::string& name, Diagnostics& diagnostics);

}  // namespace pongsim::cli
