#include "cli/view/shrink.hh"

#include <algorithm>
#include <array>
#include <cmath>

namespace pongsim::cli {

std::vector<std::uint8_t> shrink(std::span<const std::uint8_t> pixels, std::size_t width, std::size_t height,
                                 std::size_t across, std::size_t down) {
  std::vector<std::uint8_t> smaller;
  smaller.reserve(3 * across * down);
  for (std::size_t row = 0; row < down; ++row) {
    const std::size_t top = row * height / down, bottom = (row + 1) * height / down;
    for (std::size_t column = 0; column < across; ++column) {
      const std::size_t left = column * width / across, right = (column + 1) * width / across;
      std::array<std::size_t, 3> sums{};
      for (std::size_t y = top; y < bottom; ++y) {
        for (std::size_t x = left; x < right; ++x) {
          for (std::size_t i = 0; i < 3; ++i) sums[i] += pixels[3 * (y * width + x) + i];
        }
      }
      const std::size_t count = (bottom - top) * (right - left);
      for (const std::size_t sum : sums) smaller.push_back(static_cast<std::uint8_t>(sum / count));
    }
  }
  return smaller;
}

SmallPicture shrinkInto(std::span<const std::uint8_t> pixels, std::size_t width, std::size_t height, double mostAcross,
                        double mostDown) {
  const double scale = std::min({1.0, mostAcross / static_cast<double>(width), mostDown / static_cast<double>(height)});
  const auto shrunk = [scale](std::size_t length) {
    // rounding may have made an integer slightly smaller
    return std::max<std::size_t>(1, static_cast<std::size_t>(std::floor(scale * static_cast<double>(length) + 1e-9)));
  };
  SmallPicture small{shrunk(width), shrunk(height), {}};
  small.pixels = shrink(pixels, width, height, small.across, small.down);
  return small;
}

}  // namespace pongsim::cli
