#include "web/pictures/jpeg.hh"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <vector>

#include <jpeglib.h>

namespace pongsim::web {
namespace {

/// @return The pixels of a JPEG file, red, green, blue.
std::vector<std::uint8_t> decoded(const std::string& file) {
  jpeg_decompress_struct info;
  jpeg_error_mgr errors;
  info.err = jpeg_std_error(&errors);
  jpeg_create_decompress(&info);
  jpeg_mem_src(&info, reinterpret_cast<const unsigned char*>(file.data()), file.size());
  jpeg_read_header(&info, TRUE);
  info.out_color_space = JCS_RGB;
  jpeg_start_decompress(&info);
  std::vector<std::uint8_t> pixels(std::size_t{3} * info.output_width * info.output_height);
  while (info.output_scanline < info.output_height) {
    JSAMPROW row = pixels.data() + std::size_t{3} * info.output_scanline * info.output_width;
    jpeg_read_scanlines(&info, &row, 1);
  }
  jpeg_finish_decompress(&info);
  jpeg_destroy_decompress(&info);
  return pixels;
}

TEST(Jpeg, HasTheColoursOfTheImageFromTheTopDown) {
  constexpr std::uint32_t kWidth = 40, kHeight = 24;
  std::vector<std::uint8_t> pixels;
  for (std::uint32_t row = 0; row < kHeight; ++row) {
    for (std::uint32_t column = 0; column < kWidth; ++column) {
      const bool isRed = row < kHeight / 2;
      pixels.insert(pixels.end(),
                    {static_cast<std::uint8_t>(isRed ? 200 : 20), 30, static_cast<std::uint8_t>(isRed ? 20 : 180)});
    }
  }
  const std::vector<std::uint8_t> found = decoded(jpegOf(pixels, kWidth, kHeight, 90));
  ASSERT_EQ(found.size(), pixels.size());
  for (const std::size_t i : {std::size_t{0}, std::size_t{2}, found.size() - 3, found.size() - 1}) {
    EXPECT_NEAR(found[i], pixels[i], 12) << i;
  }
}

TEST(Jpeg, IsSmallerWithLessQuality) {
  std::vector<std::uint8_t> pixels(std::size_t{3} * 64 * 64);
  for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = static_cast<std::uint8_t>(i * 7919 % 251);
  EXPECT_LT(jpegOf(pixels, 64, 64, 30).size(), jpegOf(pixels, 64, 64, 90).size());
}

}  // namespace
}  // namespace pongsim::web
