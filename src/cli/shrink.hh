#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pongsim::cli {

/// @param pixels Red, green, blue, row by row from the top: three times width times height, both one at least.
/// @param across, down Of the smaller picture: from one to as many as there are.
/// @return The smaller picture: each pixel is the mean of those that fall into it.
std::vector<std::uint8_t> shrink(std::span<const std::uint8_t> pixels, std::size_t width, std::size_t height,
                                 std::size_t across, std::size_t down);

}  // namespace pongsim::cli
