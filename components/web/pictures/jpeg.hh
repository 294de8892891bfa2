#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace pongsim::web {

/// @param pixels Red, green, blue, row by row from the top; 3 width height values, with width and height up to 65,500.
/// @param quality 1 to 100.
/// @return The content of a JPEG file.
/// @throws std::runtime_error if memory runs out.
std::string jpegOf(std::span<const std::uint8_t> pixels, std::uint32_t width, std::uint32_t height, int quality);

}  // namespace pongsim::web
