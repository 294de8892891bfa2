#include "assets/images/png_image.hh"

#include <string>

namespace pongsim::assets {

std::variant<std::vector<std::uint8_t>, Problem> readRgba(std::string_view content, std::size_t mostPixels,
                                                          png_uint_32 flags, PngImage& png) {
  png_image& image = png.image;
  if (png_image_begin_read_from_memory(&image, content.data(), content.size()) == 0) {
    return Problem{std::string("can't be read as a PNG image: ") + image.message, {}};
  }
  if (std::size_t{image.width} * image.height > mostPixels) return tooManyPixels(mostPixels);
  image.flags |= flags;
  image.format = PNG_FORMAT_RGBA;
  std::vector<std::uint8_t> pixels(PNG_IMAGE_SIZE(image));
  if (png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr) == 0) {
    return Problem{std::string("can't be read as a PNG image: ") + image.message, {}};
  }
  return pixels;
}

}  // namespace pongsim::assets
