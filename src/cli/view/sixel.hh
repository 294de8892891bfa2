#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace pongsim::cli {

/// Encodes an image as sixels (DEC, "VT330/VT340 Programmer Reference Manual", volume 2, chapter 14), in 216 colours
/// with Floyd-Steinberg dithering.
/// @param pixels Red, green, blue, row by row from the top: 3 * width * height values, both at least one.
/// @return The text that makes a sixel terminal show the image at the cursor.
std::string sixels(std::span<const std::uint8_t> pixels, std::size_t width, std::size_t height);

}  // namespace pongsim::cli
