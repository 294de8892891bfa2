#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "pongsim/diagnostic.hh"
#include "pongsim/export.hh"

namespace pongsim {

/// Reads an SDF or URDF file and all files that it includes, from the folders in the environment.
/// @return One SDF 1.9 (or 1.12) text, with each `<include>` replaced by its content and absolute paths. Nothing on
/// errors, which are in `diagnostics`.
PONGSIM_API std::optional<std::string> resolvedSdf(const std::filesystem::path& file, Diagnostics& diagnostics);

}  // namespace pongsim
