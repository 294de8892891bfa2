#include "assets/images/jpeg_image.hh"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "support/jpeg_file.hh"

namespace pongsim::assets {
namespace {

using test::jpegFile;
using test::JpegKind;

TEST(JpegImage, GivesItsColorsOfWhateverKindItIs) {
  struct Case {
    const char* name;
    std::vector<std::uint8_t> given;
    JpegKind kind;
    std::vector<int> expected;
  };
  for (const auto& [name, given, kind, expected] : {
           Case{"plain", {200, 50, 10}, {}, {200, 50, 10}},
           Case{"progressive", {200, 50, 10}, {.isProgressive = true}, {200, 50, 10}},
           Case{"red, green, blue", {200, 50, 10}, {.written = JCS_RGB, .hasAdobeMarker = true}, {200, 50, 10}},
           Case{"grey", {90}, {.given = JCS_GRAYSCALE, .written = JCS_GRAYSCALE}, {90, 90, 90}},
           Case{"inks", {0, 51, 255, 51}, {.given = JCS_CMYK, .written = JCS_CMYK}, {204, 163, 0}},
           Case{"Adobe's inks",
                {255, 204, 0, 204},
                {.given = JCS_CMYK, .written = JCS_CMYK, .hasAdobeMarker = true},
                {204, 163, 0}},
           Case{"Adobe's inks as brightness and differences",
                {255, 204, 0, 204},
                {.given = JCS_CMYK, .written = JCS_YCCK, .hasAdobeMarker = true},
                {204, 163, 0}},
       }) {
    const auto read = readJpeg(jpegFile(20, given, kind), 400);
    const auto* picture = std::get_if<Picture>(&read);
    ASSERT_NE(picture, nullptr) << name << ": " << std::get<Problem>(read).text;
    EXPECT_EQ(picture->width, 20U);
    EXPECT_EQ(picture->height, 20U);
    ASSERT_EQ(picture->pixels.size(), 1600U);
    for (const std::size_t pixel : {0U, 399U}) {
      for (std::size_t channel = 0; channel < 3; ++channel) {
        EXPECT_NEAR(picture->pixels[4 * pixel + channel], expected[channel], 3) << name;
      }
      EXPECT_EQ(picture->pixels[4 * pixel + 3], 255);
    }
  }
}

TEST(JpegImage, IsRefusedWhereItIsSpoiledOrTooLarge) {
  const auto problemOf = [](const std::string& content) {
    const auto read = readJpeg(content, 400);
    return std::holds_alternative<Problem>(read) ? std::get<Problem>(read).text : "none";
  };
  const std::string good = jpegFile(20, {200, 50, 10}, {});
  EXPECT_EQ(problemOf(good), "none");
  EXPECT_EQ(problemOf(good.substr(0, good.size() - 10)), "can't be read as a JPEG image: Premature end of JPEG file");
  EXPECT_EQ(problemOf(good.substr(0, 100)), "can't be read as a JPEG image: Premature end of JPEG file");
  EXPECT_EQ(problemOf("").find("can't be read as a JPEG image: "), 0U);
  EXPECT_EQ(problemOf(jpegFile(21, {200, 50, 10}, {})), "has more than 400 pixels, which is the limit");
  // a header that claims 60,000 by 60,000 pixels: refused before decoding
  std::string large = good;
  const std::size_t frame = large.find("\xFF\xC0");
  ASSERT_NE(frame, std::string::npos);
  large.replace(frame + 5, 4, "\xEA\x60\xEA\x60");
  EXPECT_EQ(problemOf(large), "has more than 400 pixels, which is the limit");
  EXPECT_EQ(problemOf(jpegFile(20, {200, 50, 10}, {.isProgressive = true, .hasManyScans = true})),
            "can't be read as a JPEG image: it has more than 100 scans, which is the limit");
}

}  // namespace
}  // namespace pongsim::assets
