#include "assets/images/gray_image.hh"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "support/jpeg_file.hh"
#include "support/png_file.hh"
#include "support/temp_folder.hh"

namespace pongsim::assets {
namespace {

TEST(GrayImage, HasItsPixelsFromTheTop) {
  const test::TempFolder folder;
  const auto found = readGrayImage(folder.write("a.png", test::grayPng(3, {0, 10, 20, 30, 128, 255})));
  const auto* image = std::get_if<GrayImage>(&found);
  ASSERT_NE(image, nullptr) << std::get<Problem>(found).text;
  EXPECT_EQ(image->width, 3U);
  EXPECT_EQ(image->height, 2U);
  EXPECT_EQ(image->at(2, 0), 20);
  EXPECT_EQ(image->at(1, 1), 128);
}

TEST(GrayImage, MayBeAJpegWhateverItsName) {
  const test::TempFolder folder;
  const test::JpegKind gray{.given = JCS_GRAYSCALE, .written = JCS_GRAYSCALE, .quality = 100};
  const auto rowOf = [](unsigned row) { return std::vector<std::uint8_t>{static_cast<std::uint8_t>(10 * row)}; };
  const auto found = readGrayImage(folder.write("a.png", test::jpegFile(16, rowOf, gray)));
  const auto* image = std::get_if<GrayImage>(&found);
  ASSERT_NE(image, nullptr) << std::get<Problem>(found).text;
  EXPECT_EQ(image->height, 16U);
  for (std::size_t y = 0; y < 16; ++y) EXPECT_NEAR(image->at(3, y), 10 * static_cast<int>(y), 2);
}

TEST(GrayImage, SaysWhyAFileIsNotRead) {
  const test::TempFolder folder;
  const auto problemOf = [](const std::filesystem::path& file) {
    const auto found = readGrayImage(file);
    const auto* problem = std::get_if<Problem>(&found);
    return problem != nullptr ? problem->text : "(none)";
  };
  EXPECT_EQ(problemOf(folder.path() / "none.png"), "no such file");
  EXPECT_TRUE(problemOf(folder.write("a.png", "no image")).starts_with("can't be read as a PNG image: "));
  std::string huge = test::grayPng(1, {0});
  huge[18] = 100;
  EXPECT_NE(problemOf(folder.write("b.png", huge)), "(none)");
}

TEST(GrayImage, BearsBrokenFiles) {
  const test::TempFolder folder;
  std::mt19937 random(1);
  const std::string sound = test::grayPng(8, std::vector<std::uint8_t>(64, 100));
  for (int i = 0; i < 300; ++i) {
    std::string broken = sound;
    broken[random() % broken.size()] = static_cast<char>(random() & 0xFFU);
    if (i % 3 == 0) broken.resize(random() % broken.size());
    const auto found = readGrayImage(folder.write("m.png", broken));
    if (const auto* image = std::get_if<GrayImage>(&found)) {
      EXPECT_EQ(image->pixels.size(), image->width * image->height);
    }
  }
}

}  // namespace
}  // namespace pongsim::assets
