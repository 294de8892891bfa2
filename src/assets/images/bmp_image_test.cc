#include "assets/images/bmp_image.hh"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "support/temp_folder.hh"

namespace pongsim::assets {
namespace {

using BmpBytes = std::vector<std::uint8_t>;

std::string little(std::uint32_t number) {
  std::string bytes;
  for (unsigned shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(number >> shift & 255U);
  return bytes;
}

/// @param pixels Rows, each filled up to a multiple of four bytes.
std::string bmp(std::int32_t width, std::int32_t height, unsigned bits, const std::string& pixels,
                const std::string& palette = "", std::uint32_t compression = 0) {
  const std::string info = little(40) + little(static_cast<std::uint32_t>(width)) +
                           little(static_cast<std::uint32_t>(height)) + little(1 | bits << 16U) + little(compression) +
                           std::string(20, '\0');
  return "BM" + little(0) + little(0) + little(static_cast<std::uint32_t>(14 + 40 + palette.size())) + info + palette +
         pixels;
}

BmpBytes bmpPixels(const std::string& content) {
  const auto read = readBmp(content, 100);
  const auto* picture = std::get_if<Picture>(&read);
  if (picture == nullptr) ADD_FAILURE() << std::get<Problem>(read).text;
  return picture == nullptr ? BmpBytes() : picture->pixels;
}

TEST(BmpImage, IsReadFromTheBottomUnlessItsHeightIsNegative) {
  const std::string lower("\1\2\3\0", 4), upper("\4\5\6\0", 4);
  const BmpBytes upright{6, 5, 4, 255, 3, 2, 1, 255};
  EXPECT_EQ(bmpPixels(bmp(1, 2, 24, lower + upper)), upright);
  EXPECT_EQ(bmpPixels(bmp(1, -2, 24, upper + lower)), upright);
}

TEST(BmpImage, HasTheColoursOfEachKind) {
  EXPECT_EQ(bmpPixels(bmp(1, 1, 32, "\1\2\3\4")), (BmpBytes{3, 2, 1, 255}));
  const std::string palette("\1\2\3\0\4\5\6\0", 8);
  EXPECT_EQ(bmpPixels(bmp(2, 1, 8, std::string("\1\0\0\0", 4), palette)), (BmpBytes{6, 5, 4, 255, 3, 2, 1, 255}));
  EXPECT_EQ(bmpPixels(bmp(2, 1, 4, std::string("\x10\0\0\0", 4), palette)), (BmpBytes{6, 5, 4, 255, 3, 2, 1, 255}));
  EXPECT_EQ(bmpPixels(bmp(2, 1, 1, std::string("\x80\0\0\0", 4), palette)), (BmpBytes{6, 5, 4, 255, 3, 2, 1, 255}));
}

TEST(BmpImage, IsRefusedWhenItLies) {
  const std::string palette("\1\2\3\0", 4);
  for (const std::string& content :
       {std::string("BM"), bmp(1, 2, 24, "\1\2\3\4"), bmp(0, 1, 24, ""), bmp(1, 0, 24, ""), bmp(-1, 1, 24, "abcd"),
        bmp(1, INT32_MIN, 24, "abcd"), bmp(INT32_MAX, INT32_MAX, 32, "abcd"), bmp(1, 1, 16, "abcd"),
        bmp(1, 1, 24, "abcd", "", 1), bmp(1, 1, 8, "\1\0\0\0", palette)}) {
    const auto read = readBmp(content, 100);
    ASSERT_TRUE(std::holds_alternative<Problem>(read));
    EXPECT_EQ(std::get<Problem>(read).text.find("can't be read as a BMP image: "), 0U);
  }
}

TEST(BmpImage, IsReadFromAFile) {
  const pongsim::test::TempFolder folder;
  const auto read = readPicture(folder.write("p.bmp", bmp(1, 1, 24, std::string("\1\2\3\0", 4))));
  ASSERT_TRUE(std::holds_alternative<Picture>(read));
  EXPECT_EQ(std::get<Picture>(read).pixels, (BmpBytes{3, 2, 1, 255}));
}

}  // namespace
}  // namespace pongsim::assets
