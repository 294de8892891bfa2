#include "assets/picture_file.hh"

#include <fstream>
#include <string>
#include <string_view>
#include <utility>

#include "assets/jpeg_image.hh"
#include "assets/png_image.hh"

namespace pongsim::assets {

namespace {

// signatures at the start of files
constexpr std::string_view kPngStart = "\x89PNG";
constexpr std::string_view kJpegStart = "\xFF\xD8\xFF";

/// @return The first bytes of a file, enough for any signature; fewer if it is shorter.
std::string startOf(const std::filesystem::path& file) {
  std::string start(4, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(stream.gcount()));
  return start;
}

}  // namespace

std::variant<Picture, Problem> readPicture(const std::filesystem::path& file) {
  // by the signature, because many models have PNG files named .jpg
  const std::string start = startOf(file);
  if (start.starts_with(kJpegStart)) return readJpeg(file, kMostPicturePixels);
  if (!start.starts_with(kPngStart)) {
    return Problem{"is neither a PNG nor a JPEG image", "convert images in other formats (TGA, BMP, TIFF, DDS)"};
  }
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
