#pragma once

#include <cstddef>
#include <filesystem>
#include <variant>

#include "assets/picture_file.hh"
#include "assets/problem.hh"

namespace pongsim::assets {

/// Reads a JPEG file: colour, grey or inks (CMYK, converted without a colour profile), progressive or not.
/// @return The picture, opaque, or why it can't be read. Truncated and damaged files are rejected, not guessed at.
std::variant<Picture, Problem> readJpeg(const std::filesystem::path& file, std::size_t mostPixels);

}  // namespace pongsim::assets
