#include "assets/gray_image.hh"

#include <string>
#include <utility>

#include "assets/picture_file.hh"
#include "assets/png_image.hh"
#include "base/regular_file.hh"

namespace pongsim::assets {

std::variant<GrayImage, Problem> readGrayImage(const std::filesystem::path& file) {
  const auto content = base::readRegularFile(file, kLargestPictureFile);
  if (const auto* unreadable = std::get_if<base::Unreadable>(&content)) return Problem{unreadable->reason, {}};
  PngImage png;
  // 16 bits become 8 without a conversion of brightness
  auto read = readRgba(std::get<std::string>(content), kMostPixels, PNG_IMAGE_FLAG_16BIT_sRGB, png);
  if (auto* problem = std::get_if<Problem>(&read)) return std::move(*problem);
  const auto& channels = std::get<0>(read);
  GrayImage gray{png.image.width, png.image.height, {}};
  gray.pixels.reserve(gray.width * gray.height);
  for (std::size_t i = 0; i < channels.size(); i += 4) gray.pixels.push_back(channels[i]);
  return gray;
}

}  // namespace pongsim::assets
