#include "assets/images/tiff_image.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "assets/images/tiff.hh"

namespace pongsim::assets {

namespace {

constexpr tmsize_t kMostMemory = tmsize_t{256} << 20;
/// Elevations at or below this [m] mark missing data in files of geography.
constexpr double kNoData = -9999;

/// The content of a TIFF file as libtiff reads it, and the last error that libtiff reported.
struct Source {
  std::string_view content;
  std::size_t at = 0;
  std::string error;

  static tmsize_t read(thandle_t handle, void* to, tmsize_t size) {
    auto& source = *static_cast<Source*>(handle);
    const std::size_t left = source.content.size() - std::min(source.at, source.content.size());
    const std::size_t count = std::min(static_cast<std::size_t>(size), left);
    std::memcpy(to, source.content.data() + source.at, count);
    source.at += count;
    return static_cast<tmsize_t>(count);
  }

  static toff_t seek(thandle_t handle, toff_t offset, int from) {
    auto& source = *static_cast<Source*>(handle);
    if (from == SEEK_CUR) offset += source.at;
    if (from == SEEK_END) offset += source.content.size();
    source.at = static_cast<std::size_t>(offset);
    return offset;
  }

  static int fail(TIFF*, void* data, const char*, const char* format, va_list arguments) {
    std::array<char, 200> text{};
    std::vsnprintf(text.data(), text.size(), format, arguments);
    static_cast<Source*>(data)->error = text.data();
    return 1;
  }
};

struct Close {
  void operator()(TIFF* tiff) const { tiffLibrary().close(tiff); }
  void operator()(TIFFOpenOptions* options) const { tiffLibrary().openOptionsFree(options); }
};
using Tiff = std::unique_ptr<TIFF, Close>;

Tiff open(Source& source) {
  const std::unique_ptr<TIFFOpenOptions, Close> options(tiffLibrary().openOptionsAlloc());
  tiffLibrary().openOptionsSetMaxSingleMemAlloc(options.get(), kMostMemory);
  tiffLibrary().openOptionsSetErrorHandlerExtR(options.get(), Source::fail, &source);
  tiffLibrary().openOptionsSetWarningHandlerExtR(
      options.get(), [](TIFF*, void*, const char*, const char*, va_list) { return 1; }, nullptr);
  return Tiff(tiffLibrary().clientOpenExt(
      "image", "rm", &source, Source::read, [](thandle_t, void*, tmsize_t) { return tmsize_t{0}; }, Source::seek,
      [](thandle_t) { return 0; },
      [](thandle_t handle) { return static_cast<toff_t>(static_cast<Source*>(handle)->content.size()); },
      [](thandle_t, void**, toff_t*) { return 0; }, [](thandle_t, void*, toff_t) {}, options.get()));
}

/// How the samples of an image are stored.
struct Layout {
  std::uint32_t width = 0, height = 0;
  std::uint16_t bits = 1, samples = 1, format = SAMPLEFORMAT_UINT, planes = PLANARCONFIG_CONTIG;
  std::uint16_t meaning = PHOTOMETRIC_MINISBLACK;

  explicit Layout(TIFF* tiff) {
    tiffLibrary().getField(tiff, TIFFTAG_IMAGEWIDTH, &width);
    tiffLibrary().getField(tiff, TIFFTAG_IMAGELENGTH, &height);
    tiffLibrary().getFieldDefaulted(tiff, TIFFTAG_BITSPERSAMPLE, &bits);
    tiffLibrary().getFieldDefaulted(tiff, TIFFTAG_SAMPLESPERPIXEL, &samples);
    tiffLibrary().getFieldDefaulted(tiff, TIFFTAG_SAMPLEFORMAT, &format);
    tiffLibrary().getFieldDefaulted(tiff, TIFFTAG_PLANARCONFIG, &planes);
    tiffLibrary().getField(tiff, TIFFTAG_PHOTOMETRIC, &meaning);
  }

  /// @return Whether the samples are numbers that need no conversion of colours.
  bool isPlain() const {
    const bool isNumber =
        meaning == PHOTOMETRIC_MINISBLACK || meaning == PHOTOMETRIC_MINISWHITE || meaning == PHOTOMETRIC_RGB;
    const bool isFloat = format == SAMPLEFORMAT_IEEEFP && (bits == 32 || bits == 64);
    const bool isWhole = (format == SAMPLEFORMAT_UINT || format == SAMPLEFORMAT_INT || format == SAMPLEFORMAT_VOID) &&
                         (bits == 8 || bits == 16 || bits == 32);
    return isNumber && samples > 0 && (isFloat || isWhole);
  }

  /// @return Whether samples go from black at 0 to white at the highest number.
  bool isBrightness() const { return format != SAMPLEFORMAT_IEEEFP && format != SAMPLEFORMAT_INT && bits <= 16; }

  /// @return The number of bytes from pixel to pixel.
  std::size_t stride() const {
    return std::size_t{bits} / 8 * (planes == PLANARCONFIG_CONTIG ? samples : std::size_t{1});
  }

  double sampleAt(const std::uint8_t* from) const {
    const auto as = [&]<class Number>(Number number) {
      std::memcpy(&number, from, sizeof number);
      return static_cast<double>(number);
    };
    if (format == SAMPLEFORMAT_IEEEFP) return bits == 32 ? as(float{}) : as(double{});
    if (format == SAMPLEFORMAT_INT) {
      return bits == 8 ? as(std::int8_t{}) : bits == 16 ? as(std::int16_t{}) : as(std::int32_t{});
    }
    return bits == 8 ? as(std::uint8_t{}) : bits == 16 ? as(std::uint16_t{}) : as(std::uint32_t{});
  }
};

/// @param[out] values The first sample of each pixel, row by row from the top.
/// @return False where the file is damaged.
bool readTiles(TIFF* tiff, const Layout& layout, std::vector<double>& values) {
  std::uint32_t width = 0, height = 0;
  tiffLibrary().getField(tiff, TIFFTAG_TILEWIDTH, &width);
  tiffLibrary().getField(tiff, TIFFTAG_TILELENGTH, &height);
  const tmsize_t size = tiffLibrary().tileSize(tiff);
  if (width == 0 || height == 0 || size <= 0 || size > kMostMemory) return false;
  std::vector<std::uint8_t> tile(static_cast<std::size_t>(size));
  if (std::size_t{width} * height * layout.stride() > tile.size()) return false;
  for (std::uint32_t top = 0; top < layout.height; top += height) {
    for (std::uint32_t left = 0; left < layout.width; left += width) {
      if (tiffLibrary().readTile(tiff, tile.data(), left, top, 0, 0) < 0) return false;
      for (std::uint32_t y = top; y < std::min(layout.height, top + height); ++y) {
        for (std::uint32_t x = left; x < std::min(layout.width, left + width); ++x) {
          const std::size_t place = (std::size_t{y - top} * width + (x - left)) * layout.stride();
          values[std::size_t{y} * layout.width + x] = layout.sampleAt(tile.data() + place);
        }
      }
    }
  }
  return true;
}

bool readRows(TIFF* tiff, const Layout& layout, std::vector<double>& values) {
  const tmsize_t size = tiffLibrary().scanlineSize(tiff);
  if (size <= 0 || size > kMostMemory || layout.width * layout.stride() > static_cast<std::size_t>(size)) return false;
  std::vector<std::uint8_t> row(static_cast<std::size_t>(size));
  for (std::uint32_t y = 0; y < layout.height; ++y) {
    if (tiffLibrary().readScanline(tiff, row.data(), y, 0) < 0) return false;
    for (std::uint32_t x = 0; x < layout.width; ++x) {
      values[std::size_t{y} * layout.width + x] = layout.sampleAt(row.data() + x * layout.stride());
    }
  }
  return true;
}

/// @return The values from 0 to 255, as `readTiff` scales them.
std::vector<std::uint8_t> toGray(const std::vector<double>& values, const Layout& layout) {
  const auto isData = [](double value) { return std::isfinite(value) && value > kNoData; };
  double lowest = 0, highest = 255;
  if (!layout.isBrightness()) {
    lowest = std::numeric_limits<double>::infinity();
    highest = -lowest;
    for (const double value : values) {
      if (!isData(value)) continue;
      lowest = std::min(lowest, value);
      highest = std::max(highest, value);
    }
  }
  std::vector<std::uint8_t> pixels;
  pixels.reserve(values.size());
  for (const double value : values) {
    double gray = 0;
    if (layout.isBrightness()) {
      gray = layout.bits == 16 ? std::floor(value / 256) : value;
    } else if (isData(value) && highest > lowest) {
      gray = std::round((value - lowest) / (highest - lowest) * 255);
    }
    pixels.push_back(static_cast<std::uint8_t>(layout.meaning == PHOTOMETRIC_MINISWHITE ? 255 - gray : gray));
  }
  return pixels;
}

}  // namespace

std::variant<GrayImage, Problem> readTiff(std::string_view content, std::size_t mostPixels) {
  Source source{content, 0, {}};
  const auto failed = [&] {
    return Problem{"can't be read as a TIFF image: " + (source.error.empty() ? "it is damaged" : source.error), {}};
  };
  const Tiff tiff = open(source);
  if (!tiff) return failed();
  const Layout layout(tiff.get());
  const std::size_t count = std::size_t{layout.width} * layout.height;
  if (count == 0) return failed();
  if (count > mostPixels) return tooManyPixels(mostPixels);
  GrayImage image{layout.width, layout.height, {}};
  if (layout.isPlain()) {
    std::vector<double> values(count);
    const bool isRead = tiffLibrary().isTiled(tiff.get()) != 0 ? readTiles(tiff.get(), layout, values)
                                                               : readRows(tiff.get(), layout, values);
    if (!isRead) return failed();
    image.pixels = toGray(values, layout);
    return image;
  }
  std::vector<std::uint32_t> colors(count);
  if (tiffLibrary().readRGBAImageOriented(tiff.get(), layout.width, layout.height, colors.data(), ORIENTATION_TOPLEFT,
                                          1) == 0)
    return failed();
  for (const std::uint32_t color : colors) image.pixels.push_back(static_cast<std::uint8_t>(color & 0xFFU));
  return image;
}

}  // namespace pongsim::assets
