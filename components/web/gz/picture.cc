#include "web/gz/picture.hh"

#include <ignition/msgs/image.pb.h>
#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

namespace pongsim::web::gz {

namespace {

namespace im = ignition::msgs;

/// Pixels in PNG's formats.
struct Pixels {
  std::uint32_t format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> bytes;
};

/// Copies pixels with several 8-bit channels.
std::optional<Pixels> asTheyAre(const im::Image& image, std::uint32_t format) {
  const std::size_t row = std::size_t{image.width()} * PNG_IMAGE_PIXEL_CHANNELS(format);
  const std::size_t step = image.step() == 0 ? row : image.step();
  const std::size_t size = image.data().size();
  // divides, because the product may overflow
  if (step < row || size < row || (size - row) / step < image.height() - 1) return std::nullopt;
  Pixels pixels{format, {}};
  pixels.bytes.reserve(row * image.height());
  for (std::size_t y = 0; y < image.height(); ++y) {
    const auto begin = image.data().begin() + static_cast<std::ptrdiff_t>(y * step);
    pixels.bytes.insert(pixels.bytes.end(), begin, begin + static_cast<std::ptrdiff_t>(row));
  }
  return pixels;
}

/// Scales a single channel to the range from the smallest to the largest value; infinite ones are the largest.
/// @param low Upper bound of the smallest value.
template <class Number>
std::optional<Pixels> spread(const im::Image& image, double low, bool isFlipped) {
  const std::size_t count = std::size_t{image.width()} * image.height();
  if (image.data().size() / sizeof(Number) < count) return std::nullopt;
  std::vector<Number> numbers(count);
  std::memcpy(numbers.data(), image.data().data(), count * sizeof(Number));
  double high = std::numeric_limits<double>::lowest();
  for (const Number number : numbers) {
    const auto value = static_cast<double>(number);
    if (!std::isfinite(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  const double range = high > low ? high - low : 1;
  Pixels pixels{PNG_FORMAT_GRAY, std::vector<std::uint8_t>(count)};
  std::ranges::transform(numbers, pixels.bytes.begin(), [&](Number number) {
    const auto value = static_cast<double>(number);
    double part = std::isnan(value) ? 1 : std::clamp((value - low) / range, 0.0, 1.0);
    if (isFlipped) part = 1 - part;
    return static_cast<std::uint8_t>(std::lround(part * 255));
  });
  return pixels;
}

std::optional<Pixels> pixelsOf(const im::Image& image) {
  switch (image.pixel_format_type()) {
    case im::PixelFormatType::RGB_INT8:
      return asTheyAre(image, PNG_FORMAT_RGB);
    case im::PixelFormatType::BGR_INT8:
      return asTheyAre(image, PNG_FORMAT_BGR);
    case im::PixelFormatType::RGBA_INT8:
      return asTheyAre(image, PNG_FORMAT_RGBA);
    case im::PixelFormatType::BGRA_INT8:
      return asTheyAre(image, PNG_FORMAT_BGRA);
    case im::PixelFormatType::L_INT8:
      return asTheyAre(image, PNG_FORMAT_GRAY);
    case im::PixelFormatType::L_INT16:
      return spread<std::uint16_t>(image, std::numeric_limits<std::uint16_t>::max(), false);
    case im::PixelFormatType::R_FLOAT32:
      return spread<float>(image, 0, true);
    default:
      return std::nullopt;
  }
}

}  // namespace

std::optional<std::string> picture(std::span<const std::byte> bytes) {
  im::Image image;
  if (!image.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) return std::nullopt;
  if (image.width() == 0 || image.height() == 0) return std::nullopt;
  const std::optional<Pixels> pixels = pixelsOf(image);
  if (!pixels) return std::nullopt;
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = image.width();
  png.height = image.height();
  png.format = pixels->format;
  // fastest compression: others wait meanwhile, and the image is read once
  png.flags = PNG_IMAGE_FLAG_FAST;
  std::string file(PNG_IMAGE_PNG_SIZE_MAX(png), '\0');
  png_alloc_size_t size = file.size();
  const bool isWritten = png_image_write_to_memory(&png, file.data(), &size, 0, pixels->bytes.data(), 0, nullptr) != 0;
  png_image_free(&png);
  if (!isWritten) return std::nullopt;
  file.resize(size);
  return file;
}

}  // namespace pongsim::web::gz
