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

struct SmallPicture {
  std::size_t across = 1;
  std::size_t down = 1;
  std::vector<std::uint8_t> pixels;
};

/// @param mostAcross, mostDown What it may take.
/// @return The picture as large as that lets it be without being distorted; as it is where it fits, one pixel on an
/// edge at least.
SmallPicture shrinkInto(std::span<const std::uint8_t> pixels, std::size_t width, std::size_t height, double mostAcross,
                        double mostDown);

}  // namespace pongsim::cli
