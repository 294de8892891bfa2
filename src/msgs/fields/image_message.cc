#include "msgs/fields/image_message.hh"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "msgs/fields/field_reader.hh"

namespace pongsim::msgs {

namespace {

// numbers in ignition.msgs.PixelFormatType
constexpr int kLInt8 = 1, kLInt16 = 2, kRgbInt8 = 3, kBgrInt8 = 8, kRFloat32 = 13;

std::size_t bytesOf(int format) {
  if (format == kLInt8) return 1;
  if (format == kLInt16) return 2;
  if (format == kRgbInt8 || format == kBgrInt8) return 3;
  return format == kRFloat32 ? 4 : 0;
}

/// Converts distances to brightness.
class DepthScale {
 public:
  void add(float depth) {
    if (!std::isfinite(depth)) return;
    least_ = std::min(least_, depth);
    most_ = std::max(most_, depth);
  }
  std::uint8_t shade(float depth) const {
    if (!std::isfinite(depth)) return 0;
    const float share = most_ > least_ ? (depth - least_) / (most_ - least_) : 0;
    return static_cast<std::uint8_t>(std::lround(255 - 215 * share));
  }

 private:
  float least_ = INFINITY;
  float most_ = -INFINITY;
};

float depthAt(const char* data) {
  float depth = 0;
  std::memcpy(&depth, data, sizeof(depth));
  return depth;
}

}  // namespace

std::optional<ImagePixels> pixelsOf(const Message& image) {
  const FieldReader reader(image);
  const int format = static_cast<int>(reader.whole("pixel_format_type"));
  ImagePixels picture{
      static_cast<std::size_t>(reader.whole("width")), static_cast<std::size_t>(reader.whole("height")), {}};
  const std::size_t bytes = bytesOf(format), count = picture.width * picture.height;
  const std::string data = reader.bytes("data");
  if (bytes == 0 || count == 0 || data.size() / bytes / picture.width < picture.height) return std::nullopt;

  DepthScale scale;
  if (format == kRFloat32) {
    for (std::size_t i = 0; i < count; ++i) scale.add(depthAt(&data[i * bytes]));
  }
  picture.pixels.reserve(3 * count);
  for (std::size_t i = 0; i < count; ++i) {
    const char* pixel = &data[i * bytes];
    const auto channel = [&](std::size_t index) { return static_cast<std::uint8_t>(pixel[index]); };
    if (format == kRgbInt8) {
      for (const std::size_t index : {0U, 1U, 2U}) picture.pixels.push_back(channel(index));
    } else if (format == kBgrInt8) {
      for (const std::size_t index : {2U, 1U, 0U}) picture.pixels.push_back(channel(index));
    } else {
      // of 16 bits, the upper 8
      const std::uint8_t gray = format == kRFloat32 ? scale.shade(depthAt(pixel)) : channel(bytes - 1);
      picture.pixels.insert(picture.pixels.end(), 3, gray);
    }
  }
  return picture;
}

}  // namespace pongsim::msgs
