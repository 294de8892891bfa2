#include "cli/picture_plot.hh"

#include <algorithm>
#include <array>
#include <cmath>

namespace pongsim::cli {

namespace {

using BlockColor = std::array<unsigned, 3>;

/// @return The mean of a part of a picture; the ends are past the last.
BlockColor meanColor(std::span<const std::uint8_t> pixels, std::size_t width, std::array<std::size_t, 2> columns,
                     std::array<std::size_t, 2> rows) {
  std::array<std::size_t, 3> sums{};
  for (std::size_t row = rows[0]; row < rows[1]; ++row) {
    for (std::size_t column = columns[0]; column < columns[1]; ++column) {
      for (std::size_t i = 0; i < 3; ++i) sums[i] += pixels[3 * (row * width + column) + i];
    }
  }
  const std::size_t count = (rows[1] - rows[0]) * (columns[1] - columns[0]);
  return {static_cast<unsigned>(sums[0] / count), static_cast<unsigned>(sums[1] / count),
          static_cast<unsigned>(sums[2] / count)};
}

/// @param layer 38: what is written; 48: what is behind it.
std::string colorCode(int layer, const BlockColor& color) {
  return "\033[" + std::to_string(layer) + ";2;" + std::to_string(color[0]) + ";" + std::to_string(color[1]) + ";" +
         std::to_string(color[2]) + "m";
}

}  // namespace

std::string picturePlot(std::span<const std::uint8_t> pixels, std::size_t width, std::size_t height, int columns,
                        int rows) {
  const double scale = std::min({1.0, columns / static_cast<double>(width), 2.0 * rows / static_cast<double>(height)});
  const auto blocksOf = [scale](std::size_t length) {
    return std::max<std::size_t>(1, static_cast<std::size_t>(std::floor(scale * static_cast<double>(length) + 1e-9)));
  };
  const std::size_t across = blocksOf(width), down = blocksOf(height);
  const auto color = [&](std::size_t column, std::size_t row) {
    return meanColor(pixels, width, {column * width / across, (column + 1) * width / across},
                     {row * height / down, (row + 1) * height / down});
  };
  std::string text;
  for (std::size_t row = 0; row < down; row += 2) {
    for (std::size_t column = 0; column < across; ++column) {
      text += colorCode(38, color(column, row));
      // an odd last row has nothing below it
      text += row + 1 < down ? colorCode(48, color(column, row + 1)) : "\033[49m";
      text += "\u2580";
    }
    text += "\033[0m\n";
  }
  return text;
}

}  // namespace pongsim::cli
