#include "assets/images/tiff_image.hh"

#include <gtest/gtest.h>
#include <tiffio.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "support/temp_folder.hh"

namespace pongsim::assets {
namespace {

constexpr std::uint32_t kWidth = 40, kHeight = 20;

/// Settings of a test image beyond those of a grey image in rows.
struct Kind {
  std::uint16_t format = SAMPLEFORMAT_UINT;
  std::uint16_t samples = 1;
  std::uint16_t meaning = PHOTOMETRIC_MINISBLACK;
  std::uint16_t compression = COMPRESSION_NONE;
  bool isTiled = false;
};

/// @param valueAt Of each column and row.
/// @return The content of a TIFF file, as libtiff writes it.
template <class Number, class ValueAt>
std::string tiffOf(const Kind& kind, const ValueAt& valueAt) {
  const test::TempFolder folder;
  const std::string file = (folder.path() / "a.tif").string();
  TIFF* tiff = TIFFOpen(file.c_str(), "w");
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, kWidth);
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, kHeight);
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 8 * sizeof(Number));
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, kind.samples);
  TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, kind.format);
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, kind.meaning);
  TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  TIFFSetField(tiff, TIFFTAG_COMPRESSION, kind.compression);
  const std::uint32_t side = kind.isTiled ? 16 : 1;
  if (kind.isTiled) {
    TIFFSetField(tiff, TIFFTAG_TILEWIDTH, side);
    TIFFSetField(tiff, TIFFTAG_TILELENGTH, side);
  } else {
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, 3);
  }
  const std::uint32_t width = kind.isTiled ? side : kWidth;
  for (std::uint32_t top = 0; top < kHeight; top += side) {
    for (std::uint32_t left = 0; left < kWidth; left += width) {
      std::vector<Number> values;
      for (std::uint32_t y = 0; y < side; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) {
          for (int s = 0; s < kind.samples; ++s)
            values.push_back(s == 0 ? static_cast<Number>(valueAt(left + x, top + y)) : Number{1});
        }
      }
      if (kind.isTiled) {
        TIFFWriteTile(tiff, values.data(), left, top, 0, 0);
      } else {
        TIFFWriteScanline(tiff, values.data(), top, 0);
      }
    }
  }
  TIFFClose(tiff);
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

GrayImage imageOf(const std::string& content) {
  auto read = readTiff(content, kMostPixels);
  if (const auto* problem = std::get_if<Problem>(&read)) {
    ADD_FAILURE() << problem->text;
    return {};
  }
  return std::get<GrayImage>(std::move(read));
}

TEST(TiffImage, HasItsPixelsFromTheTopHoweverTheyAreStored) {
  for (const bool isTiled : {false, true}) {
    for (const int compression : {COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE}) {
      for (const int samples : {1, 3}) {
        Kind kind;
        kind.samples = static_cast<std::uint16_t>(samples);
        kind.compression = static_cast<std::uint16_t>(compression);
        kind.isTiled = isTiled;
        if (samples == 3) kind.meaning = PHOTOMETRIC_RGB;
        const GrayImage image = imageOf(tiffOf<std::uint8_t>(kind, [](auto x, auto y) { return 5 * x + y; }));
        ASSERT_EQ(image.width, kWidth);
        ASSERT_EQ(image.height, kHeight);
        for (std::size_t y = 0; y < kHeight; ++y) {
          for (std::size_t x = 0; x < kWidth; ++x) ASSERT_EQ(image.at(x, y), 5 * x + y) << x << " " << y;
        }
      }
    }
  }
}

TEST(TiffImage, TakesTheUpperHalfOf16Bits) {
  const GrayImage image = imageOf(tiffOf<std::uint16_t>({}, [](auto x, auto) { return x * 1600; }));
  EXPECT_EQ(image.at(0, 0), 0);
  EXPECT_EQ(image.at(39, 7), 39 * 1600 / 256);
}

TEST(TiffImage, ScalesElevationsFromTheLowestToTheHighest) {
  const Kind kind{.format = SAMPLEFORMAT_IEEEFP, .isTiled = true};
  // the first column has no data
  const GrayImage image =
      imageOf(tiffOf<float>(kind, [](auto x, auto) { return x == 0 ? -32767.0F : 100 + static_cast<float>(x); }));
  EXPECT_EQ(image.at(0, 3), 0);
  EXPECT_EQ(image.at(1, 3), 0);
  EXPECT_EQ(image.at(20, 3), 128);
  EXPECT_EQ(image.at(39, 3), 255);
  const GrayImage flat = imageOf(tiffOf<double>({.format = SAMPLEFORMAT_IEEEFP}, [](auto, auto) { return 7; }));
  EXPECT_EQ(flat.at(5, 5), 0);
  const GrayImage below = imageOf(tiffOf<std::int16_t>({.format = SAMPLEFORMAT_INT}, [](auto x, auto) { return -x; }));
  EXPECT_EQ(below.at(0, 0), 255);
  EXPECT_EQ(below.at(39, 0), 0);
}

TEST(TiffImage, MayHaveWhiteAt0) {
  const GrayImage image =
      imageOf(tiffOf<std::uint8_t>({.meaning = PHOTOMETRIC_MINISWHITE}, [](auto x, auto) { return x; }));
  EXPECT_EQ(image.at(3, 0), 252);
}

TEST(TiffImage, SaysWhyItIsNotRead) {
  const auto problemOf = [](const std::string& content, std::size_t most) {
    const auto read = readTiff(content, most);
    const auto* problem = std::get_if<Problem>(&read);
    return problem != nullptr ? problem->text : "(none)";
  };
  EXPECT_TRUE(problemOf("II*", kMostPixels).starts_with("can't be read as a TIFF image: "));
  const std::string sound = tiffOf<std::uint8_t>({}, [](auto x, auto) { return x; });
  EXPECT_NE(problemOf(sound, 100), "(none)");
  EXPECT_TRUE(problemOf(sound.substr(0, sound.size() / 2), kMostPixels).starts_with("can't be read as a TIFF image: "));
}

TEST(TiffImage, BearsBrokenFiles) {
  std::mt19937 random(1);
  const std::string sound =
      tiffOf<float>({.format = SAMPLEFORMAT_IEEEFP, .compression = COMPRESSION_LZW, .isTiled = true},
                    [](auto x, auto y) { return static_cast<float>(x * y); });
  for (int i = 0; i < 1000; ++i) {
    std::string broken = sound;
    for (int k = 0; k < 3; ++k) broken[random() % broken.size()] = static_cast<char>(random() & 0xFFU);
    if (i % 3 == 0) broken.resize(random() % broken.size());
    const auto read = readTiff(broken, kMostPixels);
    if (const auto* image = std::get_if<GrayImage>(&read)) {
      EXPECT_EQ(image->pixels.size(), image->width * image->height);
    }
  }
}

}  // namespace
}  // namespace pongsim::assets
