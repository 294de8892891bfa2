#pragma once

#include <cstddef>
#include <string_view>
#include <variant>

#include "assets/images/picture_file.hh"
#include "assets/problem.hh"

namespace pongsim::assets {

/// @return Whether content may be that of a TGA file, which has no signature: its header says what one can say.
bool looksLikeTga(std::string_view content);

/// Decodes the content of a TGA file: colours of 16, 24 or 32 bits, grey or a palette of these, run-length encoded or
/// not.
/// @return The picture, or why it can't be read. Truncated files are rejected.
std::variant<Picture, Problem> readTga(std::string_view content, std::size_t mostPixels);

}  // namespace pongsim::assets
