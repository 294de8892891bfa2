#pragma once

#include <cstddef>
#include <filesystem>
#include <variant>

#include "assets/picture_file.hh"
#include "assets/problem.hh"

namespace pongsim::assets {

/// Reads a JPEG file: of colours, grey or of inks (CMYK), whose colours are reckoned without a profile; progressive or
/// not.
/// @return The picture, opaque, or why it can't be had. A file that is cut off or spoiled is refused, not guessed at.
std::variant<Picture, Problem> readJpeg(const std::filesystem::path& file, std::size_t mostPixels);

}  // namespace pongsim::assets
