#pragma once

#include <cstddef>
#include <string_view>
#include <variant>

#include "assets/images/picture_file.hh"
#include "assets/problem.hh"

namespace pongsim::assets {

/// Decodes the content of a JPEG file: colour, grey or inks (CMYK, converted without a colour profile), progressive or
/// not.
/// @return The picture, opaque, or why it can't be read. Truncated and damaged files are rejected, not guessed at.
std::variant<Picture, Problem> readJpeg(std::string_view content, std::size_t mostPixels);

}  // namespace pongsim::assets
