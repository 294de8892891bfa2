#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "description/world.hh"
#include "pongsim/diagnostic.hh"

namespace pongsim::sdf {

/// What an SDF file describes.
struct Root {
  std::vector<description::World> worlds;
};

/// Reads a file. All that is wrong with it is added to `diagnostics`, in one go; what the result holds is of use
/// only if there was no error.
Root loadFile(const std::filesystem::path& file, Diagnostics& diagnostics);

/// As `loadFile`, from text; `name` stands in the diagnostics.
Root loadText(std::string_view text, std::string_view name, Diagnostics& diagnostics);

}  // namespace pongsim::sdf
