#include "assets/picture_file.hh"

#include <string>
#include <utility>

#include "assets/png_image.hh"

namespace pongsim::assets {

std::variant<Picture, Problem> readPicture(const std::filesystem::path& file) {
  PngImage png;
  auto pixels = readRgba(file, kMostPicturePixels, 0, png);
  if (auto* problem = std::get_if<Problem>(&pixels)) return std::move(*problem);
  return Picture{png.image.width, png.image.height, std::get<0>(std::move(pixels))};
}

std::optional<Problem> writePicture(const std::filesystem::path& file, std::size_t width, std::size_t height,
                                    std::span<const std::uint8_t> pixels) {
  PngImage png;
  png.image.width = static_cast<png_uint_32>(width);
  png.image.height = static_cast<png_uint_32>(height);
  png.image.format = PNG_FORMAT_RGB;
  if (png_image_write_to_file(&png.image, file.c_str(), 0, pixels.data(), 0, nullptr) != 0) return std::nullopt;
  return Problem{std::string("can't be written: ") + png.image.message, {}};
}

}  // namespace pongsim::assets
