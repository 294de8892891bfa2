#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "pongsim/diagnostic.hh"

namespace pongsim::sdf {

/// Reads a `model.config`, which lists a model's SDF files by version.
/// @param name What diagnostics call the file.
/// @return The file of the newest version that is supported, else the first one; nothing, and an error added, where
/// none is named.
std::optional<std::filesystem::path> readModelConfig(const std::filesystem::path& file,
                                                     const std::shared_ptr<const std::string>& name,
                                                     Diagnostics& diagnostics);

}  // namespace pongsim::sdf
