#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace pongsim::cli {

/// Draws an image with blocks of colour, two above each other in each character, as large as possible without
/// distortion.
/// @param pixels Red, green, blue, row by row from the top: 3 * width * height values, both at least one.
/// @param columns, rows Available characters, at least one.
/// @return Lines, each with its line break, for terminals with 24-bit colours.
std::string picturePlot(std::span<const std::uint8_t> pixels, std::size_t width, std::size_t height, int columns,
                        int rows);

}  // namespace pongsim::cli
