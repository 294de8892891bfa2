#include "assets/images/picture_file.hh"

#include <string>
#include <string_view>
#include <utility>

#include "assets/images/bmp_image.hh"
#include "assets/images/jpeg_image.hh"
#include "assets/images/png_image.hh"
#include "assets/images/tga_image.hh"
#include "base/regular_file.hh"

namespace pongsim::assets {

namespace {

// signatures at the start of files
constexpr std::string_view kPngStart = "\x89PNG";
constexpr std::string_view kJpegStart = "\xFF\xD8\xFF";
constexpr std::string_view kBmpStart = "BM";

}  // namespace

std::variant<Picture, Problem> readPicture(const std::filesystem::path& file) {
  const auto read = base::readRegularFile(file, kLargestPictureFile);
  if (const auto* unreadable = std::get_if<base::Unreadable>(&read)) return Problem{unreadable->reason, {}};
  return decodePicture(std::get<std::string>(read));
}

std::variant<Picture, Problem> decodePicture(std::string_view content) {
  // by the signature, because many models have PNG files named .jpg
  if (content.starts_with(kJpegStart)) return readJpeg(content, kMostPicturePixels);
  if (content.starts_with(kBmpStart)) return readBmp(content, kMostPicturePixels);
  if (!content.starts_with(kPngStart)) {
    if (looksLikeTga(content)) return readTga(content, kMostPicturePixels);
    return Problem{"is not a PNG, JPEG, TGA or BMP image", "convert images in other formats (TIFF, DDS)"};
  }
  PngImage png;
  auto pixels = readRgba(content, kMostPicturePixels, 0, png);
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
