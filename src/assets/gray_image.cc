#include "assets/gray_image.hh"

#include <png.h>

#include <string>

namespace pongsim::assets {

namespace {

/// libpng's image, freed with this object.
struct PngImage {
  PngImage() { image.version = PNG_IMAGE_VERSION; }
  ~PngImage() { png_image_free(&image); }
  PngImage(const PngImage&) = delete;
  PngImage& operator=(const PngImage&) = delete;

  png_image image{};
};

}  // namespace

std::variant<GrayImage, Problem> readGrayImage(const std::filesystem::path& file) {
  PngImage png;
  png_image& image = png.image;
  if (png_image_begin_read_from_file(&image, file.c_str()) == 0) {
    return Problem{std::string("can't be read as a PNG image: ") + image.message, {}};
  }
  if (std::size_t{image.width} * image.height > kMostPixels) {
    return Problem{"has more than " + std::to_string(kMostPixels) + " pixels, which is the limit", {}};
  }
  // 16 bits become 8 as they are, without a change of brightness
  image.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;
  image.format = PNG_FORMAT_RGBA;
  std::vector<png_byte> channels(PNG_IMAGE_SIZE(image));
  if (png_image_finish_read(&image, nullptr, channels.data(), 0, nullptr) == 0) {
    return Problem{std::string("can't be read as a PNG image: ") + image.message, {}};
  }
  GrayImage gray{image.width, image.height, {}};
  gray.pixels.reserve(gray.width * gray.height);
  for (std::size_t i = 0; i < channels.size(); i += 4) gray.pixels.push_back(channels[i]);
  return gray;
}

}  // namespace pongsim::assets
