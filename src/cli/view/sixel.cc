#include "cli/view/sixel.hh"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace pongsim::cli {

namespace {

/// Number of shades of each of red, green and blue.
constexpr int kShades = 6;
constexpr std::size_t kSixelColors = kShades * kShades * kShades;
/// Rows of a band, which is written at once, with one character for each column.
constexpr std::size_t kBandRows = 6;

/// @return The colour of each pixel.
std::vector<std::uint8_t> spreadColors(std::span<const std::uint8_t> pixels, std::size_t width, std::size_t height) {
  std::vector<std::uint8_t> colors(width * height);
  // accumulated errors of the pixels in this row and the next, in sixteenths, with one more pixel on either side
  std::vector<std::array<int, 3>> here(width + 2), below(width + 2);
  for (std::size_t row = 0; row < height; ++row) {
    std::ranges::fill(below, std::array<int, 3>{});
    for (std::size_t column = 0; column < width; ++column) {
      int color = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const int wanted = pixels[3 * (row * width + column) + i] + here[column + 1][i] / 16;
        const int shade = std::clamp((wanted * (kShades - 1) + 127) / 255, 0, kShades - 1);
        const int error = wanted - shade * 255 / (kShades - 1);
        here[column + 2][i] += 7 * error;
        below[column][i] += 3 * error;
        below[column + 1][i] += 5 * error;
        below[column + 2][i] += error;
        color = color * kShades + shade;
      }
      colors[row * width + column] = static_cast<std::uint8_t>(color);
    }
    std::swap(here, below);
  }
  return colors;
}

/// Red, green and blue in percent.
std::string definitionOf(std::size_t color) {
  constexpr std::size_t kHundredths = 100 / (kShades - 1);
  const std::size_t shares[] = {color / kShades / kShades, color / kShades % kShades, color % kShades};
  std::string text = "#" + std::to_string(color) + ";2";
  for (const std::size_t share : shares) text += ";" + std::to_string(share * kHundredths);
  return text;
}

/// @param count How often to repeat the character.
void appendRun(char letter, std::size_t count, std::string& text) {
  if (count > 3) {
    text += "!" + std::to_string(count) + letter;
  } else {
    text.append(count, letter);
  }
}

/// Adds the pixels of one colour in a band.
void appendColor(std::size_t color, std::span<const std::uint8_t> band, std::size_t width, std::string& text) {
  text += "#" + std::to_string(color);
  const std::size_t rows = band.size() / width;
  char before = 0;
  std::size_t count = 0;
  for (std::size_t column = 0; column < width; ++column) {
    int bits = 0;
    for (std::size_t row = 0; row < rows; ++row) {
      if (band[row * width + column] == color) bits |= 1 << row;
    }
    const char letter = static_cast<char>('?' + bits);
    if (letter != before) {
      appendRun(before, count, text);
      count = 0;
    }
    before = letter;
    ++count;
  }
  // trailing blanks are not needed
  if (before != '?') appendRun(before, count, text);
}

}  // namespace

std::string sixels(std::span<const std::uint8_t> pixels, std::size_t width, std::size_t height) {
  const std::vector<std::uint8_t> colors = spreadColors(pixels, width, height);
  std::array<bool, kSixelColors> isDefined{};
  std::string text = "\033P0;1q\"1;1;" + std::to_string(width) + ";" + std::to_string(height);
  for (std::size_t top = 0; top < height; top += kBandRows) {
    const std::size_t rows = std::min(kBandRows, height - top);
    const std::span<const std::uint8_t> band(colors.data() + top * width, rows * width);
    std::array<bool, kSixelColors> isThere{};
    for (const std::uint8_t color : band) isThere[color] = true;
    for (std::size_t color = 0; color < kSixelColors; ++color) {
      if (!isThere[color]) continue;
      if (!isDefined[color]) text += definitionOf(color);
      isDefined[color] = true;
      appendColor(color, band, width, text);
      text += '$';
    }
    text += '-';
  }
  return text + "\033\\";
}

}  // namespace pongsim::cli
