#include "cli/view/picture_plot.hh"

#include "cli/view/shrink.hh"

namespace pongsim::cli {

namespace {

/// @param layer 38: foreground; 48: background.
std::string colorCode(int layer, const std::uint8_t* color) {
  return "\033[" + std::to_string(layer) + ";2;" + std::to_string(color[0]) + ";" + std::to_string(color[1]) + ";" +
         std::to_string(color[2]) + "m";
}

}  // namespace

std::string picturePlot(std::span<const std::uint8_t> pixels, std::size_t width, std::size_t height, int columns,
                        int rows) {
  const auto& [across, down, blocks] = shrinkInto(pixels, width, height, columns, 2.0 * rows);
  const auto color = [across = across, &blocks = blocks](std::size_t column, std::size_t row) {
    return &blocks[3 * (row * across + column)];
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
