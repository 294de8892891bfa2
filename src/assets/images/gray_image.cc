#include "assets/images/gray_image.hh"

#include <string>
#include <string_view>
#include <utility>

#include "assets/images/jpeg_image.hh"
#include "assets/images/picture_file.hh"
#include "assets/images/png_image.hh"
#include "assets/images/tiff_image.hh"
#include "base/regular_file.hh"

namespace pongsim::assets {

namespace {

/// @param channels Four of each pixel, red first.
GrayImage redOf(std::size_t width, std::size_t height, const std::vector<std::uint8_t>& channels) {
  GrayImage gray{width, height, {}};
  gray.pixels.reserve(width * height);
  for (std::size_t i = 0; i < channels.size(); i += 4) gray.pixels.push_back(channels[i]);
  return gray;
}

}  // namespace

std::variant<GrayImage, Problem> readGrayImage(const std::filesystem::path& file) {
  const auto content = base::readRegularFile(file, kLargestPictureFile);
  if (const auto* unreadable = std::get_if<base::Unreadable>(&content)) return Problem{unreadable->reason, {}};
  const auto& bytes = std::get<std::string>(content);
  if (bytes.starts_with("\xFF\xD8\xFF")) {
    auto jpeg = readJpeg(bytes, kMostPixels);
    if (auto* problem = std::get_if<Problem>(&jpeg)) return std::move(*problem);
    const auto& picture = std::get<Picture>(jpeg);
    return redOf(picture.width, picture.height, picture.pixels);
  }
  // little-endian, big-endian; with offsets of 32 bits or of 64
  for (const std::string_view start : {"II*", "II+", "MM"}) {
    if (bytes.starts_with(start)) return readTiff(bytes, kMostPixels);
  }
  PngImage png;
  // 16 bits become 8 without a conversion of brightness
  auto read = readRgba(bytes, kMostPixels, PNG_IMAGE_FLAG_16BIT_sRGB, png);
  if (auto* problem = std::get_if<Problem>(&read)) return std::move(*problem);
  return redOf(png.image.width, png.image.height, std::get<0>(read));
}

}  // namespace pongsim::assets
