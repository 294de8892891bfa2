#include "assets/picture_file.hh"

#include <png.h>

#include <string>

namespace pongsim::assets {

namespace {

/// libpng's image, freed with this object.
struct PngPicture {
  PngPicture() { image.version = PNG_IMAGE_VERSION; }
  ~PngPicture() { png_image_free(&image); }
  PngPicture(const PngPicture&) = delete;
  PngPicture& operator=(const PngPicture&) = delete;

  png_image image{};
};

}  // namespace

std::variant<Picture, Problem> readPicture(const std::filesystem::path& file) {
  PngPicture png;
  png_image& image = png.image;
  if (png_image_begin_read_from_file(&image, file.c_str()) == 0) {
    return Problem{std::string("can't be read as a PNG image: ") + image.message, {}};
  }
  if (std::size_t{image.width} * image.height > kMostPicturePixels) {
    return Problem{"has more than " + std::to_string(kMostPicturePixels) + " pixels, which is the limit", {}};
  }
  image.format = PNG_FORMAT_RGBA;
  Picture picture{image.width, image.height, std::vector<std::uint8_t>(PNG_IMAGE_SIZE(image))};
  if (png_image_finish_read(&image, nullptr, picture.pixels.data(), 0, nullptr) == 0) {
    return Problem{std::string("can't be read as a PNG image: ") + image.message, {}};
  }
  return picture;
}

std::optional<Problem> writePicture(const std::filesystem::path& file, std::size_t width, std::size_t height,
                                    std::span<const std::uint8_t> pixels) {
  PngPicture png;
  png.image.width = static_cast<png_uint_32>(width);
  png.image.height = static_cast<png_uint_32>(height);
  png.image.format = PNG_FORMAT_RGB;
  if (png_image_write_to_file(&png.image, file.c_str(), 0, pixels.data(), 0, nullptr) != 0) return std::nullopt;
  return Problem{std::string("can't be written: ") + png.image.message, {}};
}

}  // namespace pongsim::assets
