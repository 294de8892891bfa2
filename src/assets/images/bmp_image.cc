// Windows bitmaps with a BITMAPINFOHEADER or one of its longer successors.
#include "assets/images/bmp_image.hh"

#include <cstdint>
#include <limits>
#include <string>

namespace pongsim::assets {

namespace {

constexpr std::size_t kFileHeader = 14, kInfoHeader = 40;

/// A number of some bytes, the lowest first.
std::uint32_t bmpNumberAt(std::string_view content, std::size_t at, std::size_t bytes) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < bytes; ++i) {
    number |= std::uint32_t{static_cast<std::uint8_t>(content[at + i])} << (8 * static_cast<unsigned>(i));
  }
  return number;
}

}  // namespace

std::variant<Picture, Problem> readBmp(std::string_view content, std::size_t mostPixels) {
  const auto problem = [](const std::string& what) { return Problem{"can't be read as a BMP image: " + what, {}}; };
  if (content.size() < kFileHeader + kInfoHeader) return problem("it ends early");
  const std::size_t start = bmpNumberAt(content, 10, 4), info = bmpNumberAt(content, 14, 4);
  const auto width = static_cast<std::int32_t>(bmpNumberAt(content, 18, 4));
  const auto height = static_cast<std::int32_t>(bmpNumberAt(content, 22, 4));
  const std::uint32_t bits = bmpNumberAt(content, 28, 2), compression = bmpNumberAt(content, 30, 4);
  if (info < kInfoHeader || compression != 0 || !(bits == 1 || bits == 4 || bits == 8 || bits == 24 || bits == 32)) {
    return problem("it is of a kind that is not supported, such as a compressed one");
  }
  if (width <= 0 || height == 0 || height == std::numeric_limits<std::int32_t>::min()) return problem("it has no size");
  const auto columns = static_cast<std::size_t>(width), rows = static_cast<std::size_t>(height < 0 ? -height : height);
  if (columns * rows > mostPixels) return problem("it has more than " + std::to_string(mostPixels) + " pixels");
  const std::size_t rowBytes = (columns * bits + 31) / 32 * 4;
  if (start > content.size() || content.size() - start < rowBytes * rows) return problem("it ends early");
  const std::size_t palette = kFileHeader + info;

  Picture picture{columns, rows, {}};
  picture.pixels.reserve(4 * columns * rows);
  for (std::size_t row = 0; row < rows; ++row) {
    // from the bottom, unless the height is negative
    const std::size_t line = start + rowBytes * (height < 0 ? row : rows - 1 - row);
    for (std::size_t column = 0; column < columns; ++column) {
      std::size_t color = line + column * bits / 8;
      if (bits <= 8) {
        const std::size_t shift = 8 - bits - column * bits % 8;
        const std::size_t index = bmpNumberAt(content, color, 1) >> shift & ((1U << bits) - 1);
        color = palette + 4 * index;
        if (color + 4 > start) return problem("it has colours that its palette has not");
      }
      // blue first
      for (const std::size_t channel : {2U, 1U, 0U}) {
        picture.pixels.push_back(static_cast<std::uint8_t>(content[color + channel]));
      }
      picture.pixels.push_back(255);
    }
  }
  return picture;
}

}  // namespace pongsim::assets
