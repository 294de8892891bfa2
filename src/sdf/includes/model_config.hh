#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "pongsim/diagnostic.hh"

namespace pongsim::sdf {

/// Reads a `model.config`, which lists a model's SDF files by version.
/// @param name Name of the file in diagnostics.
/// @return The file of the newest version that Fortress reads, else of the newest supported one, else the first one;
/// nothing, with an error, if none is named.
std::optional<std::filesystem::path> readModelConfig(const std::filesystem::path& file,
                                                     const std::shared_ptr<const std::string>& name,
                                                     Diagnostics& diagnostics);

}  // namespace pongsim::sdf
