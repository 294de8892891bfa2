#pragma once

#include <cstddef>
#include <string_view>
#include <variant>

#include "assets/images/picture_file.hh"
#include "assets/problem.hh"

namespace pongsim::assets {

/// Decodes the content of a BMP file that is not compressed: colours of 24 or 32 bits, or a palette of 2, 16 or 256.
/// @return The picture, opaque, or why it can't be read. Truncated files are rejected.
std::variant<Picture, Problem> readBmp(std::string_view content, std::size_t mostPixels);

}  // namespace pongsim::assets
