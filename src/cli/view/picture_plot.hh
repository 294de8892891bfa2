#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace pongsim::cli {

/// Draws a picture with blocks of colour, two above each other in a letter, as large as it goes without being
/// distorted.
/// @param pixels Red, green, blue, row by row from the top: three times width times height, both one at least.
/// @param columns, rows Of letters that it may take, one at least.
/// @return Lines, each with its end, for terminals that know 24-bit colours.
std::string picturePlot(std::span<const std::uint8_t> pixels, std::size_t width, std::size_t height, int columns,
                        int rows);

}  // namespace pongsim::cli
