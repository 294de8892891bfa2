#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pongsim::cli {

/// @param pixels Red, green, blue, row by row from the top: 3 * width * height values, both at least one.
/// @param across, down Size of the result: from one to the original size.
/// @return The smaller image: each pixel is the mean of those that it covers.
std::vector<std::uint8_t> shrink(std::span<const std::uint8_t> pixels, std::size_t width, std::size_t height,
                                 std::size_t across, std::size_t down);

struct SmallPicture {
  std::size_t across = 1;
  std::size_t down = 1;
  std::vector<std::uint8_t> pixels;
};

/// @param mostAcross, mostDown Available size.
/// @return The image, as large as fits without distortion; unchanged if it fits, and at least one pixel wide and high.
SmallPicture shrinkInto(std::span<const std::uint8_t> pixels, std::size_t width, std::size_t height, double mostAcross,
                        double mostDown);

}  // namespace pongsim::cli
