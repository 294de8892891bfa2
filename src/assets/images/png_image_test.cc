#include "assets/images/png_image.hh"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "assets/images/picture_file.hh"
#include "base/regular_file.hh"
#include "support/temp_folder.hh"

namespace pongsim::assets {
namespace {

TEST(PngImage, GivesItsPixelsWithOpacity) {
  const pongsim::test::TempFolder folder;
  const std::array<std::uint8_t, 6> pixels{1, 2, 3, 40, 50, 60};
  ASSERT_FALSE(writePicture(folder.path() / "two.png", 2, 1, pixels));
  PngImage png;
  const auto content = std::get<std::string>(base::readRegularFile(folder.path() / "two.png", 1000));
  const auto read = readRgba(content, 2, 0, png);
  EXPECT_EQ(std::get<0>(read), (std::vector<std::uint8_t>{1, 2, 3, 255, 40, 50, 60, 255}));
  EXPECT_EQ(png.image.width, 2U);
  PngImage limited;
  EXPECT_EQ(std::get<Problem>(readRgba(content, 1, 0, limited)).text, "has more than 1 pixels, which is the limit");
}

TEST(PngImage, SaysWhyItCanNotBeRead) {
  PngImage png;
  const auto read = readRgba("no picture", 100, 0, png);
  EXPECT_EQ(std::get<Problem>(read).text.find("can't be read as a PNG image: "), 0U);
}

}  // namespace
}  // namespace pongsim::assets
