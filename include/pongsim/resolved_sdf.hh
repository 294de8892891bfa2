#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "pongsim/diagnostic.hh"
#include "pongsim/export.hh"

namespace pongsim {

/// Reads a file of SDF or URDF and all that it includes, in the folders that the environment names.
/// @return It as one text of SDF 1.9: what is included stands in place of each `<include>`, and paths of files in it
/// are absolute. Nothing, with the reason in `diagnostics`, where there was an error.
PONGSIM_API std::optional<std::string> resolvedSdf(const std::filesystem::path& file, Diagnostics& diagnostics);

}  // namespace pongsim
