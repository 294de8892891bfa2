#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace pongsim::cli {

/// Writes a picture as sixels (DEC, "VT330/VT340 Programmer Reference Manual", volume 2, chapter 14): in 216 colours,
/// whose errors are spread by Floyd and Steinberg's rule.
/// @param pixels Red, green, blue, row by row from the top: three times width times height, both one at least.
/// @return What a terminal that knows sixels shows at its cursor.
std::string sixels(std::span<const std::uint8_t> pixels, std::size_t width, std::size_t height);

}  // namespace pongsim::cli
