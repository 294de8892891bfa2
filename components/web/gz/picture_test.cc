#include "web/gz/picture.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/image.pb.h>
#include <png.h>

#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

namespace pongsim::web::gz {
namespace {

namespace im = ignition::msgs;

im::Image image(std::uint32_t width, std::uint32_t height, im::PixelFormatType format, std::string data) {
  im::Image message;
  message.set_width(width);
  message.set_height(height);
  message.set_pixel_format_type(format);
  message.set_data(std::move(data));
  return message;
}

std::optional<std::string> pictureOf(const im::Image& message) {
  const std::string bytes = message.SerializeAsString();
  return picture(std::as_bytes(std::span(bytes)));
}

/// @return The image's pixels as red, green and blue; empty if it is no image.
std::vector<int> pixels(const std::optional<std::string>& file) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  if (!file || png_image_begin_read_from_memory(&png, file->data(), file->size()) == 0) return {};
  png.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> bytes(PNG_IMAGE_SIZE(png));
  png_image_finish_read(&png, nullptr, bytes.data(), 0, nullptr);
  return {bytes.begin(), bytes.end()};
}

TEST(Picture, HasColoursAsTheyAre) {
  EXPECT_EQ(pixels(pictureOf(image(2, 1, im::RGB_INT8, "\x01\x02\x03\x04\x05\x06"))),
            (std::vector<int>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(pixels(pictureOf(image(1, 1, im::BGR_INT8, "\x01\x02\x03"))), (std::vector<int>{3, 2, 1}));
  EXPECT_EQ(pixels(pictureOf(image(1, 2, im::L_INT8, "\x09\x08"))), (std::vector<int>{9, 9, 9, 8, 8, 8}));
}

TEST(Picture, TakesRowsThatAreLongerThanTheirPixels) {
  im::Image padded = image(1, 2, im::L_INT8,
                           "ax"
                           "b");
  padded.set_step(2);
  EXPECT_EQ(pixels(pictureOf(padded)), (std::vector<int>{'a', 'a', 'a', 'b', 'b', 'b'}));
}

TEST(Picture, IsWhiteWhereItIsNear) {
  const float depths[] = {0, 1, std::numeric_limits<float>::infinity(), 2};
  const std::string data(reinterpret_cast<const char*>(depths), sizeof depths);
  const std::vector<int> found = pixels(pictureOf(image(4, 1, im::R_FLOAT32, data)));
  ASSERT_EQ(found.size(), 12U);
  EXPECT_EQ(found[0], 255);
  EXPECT_NEAR(found[3], 128, 1);
  EXPECT_EQ(found[6], 0);
  EXPECT_EQ(found[9], 0);
}

TEST(Picture, SpreadsHeat) {
  const std::uint16_t heat[] = {1000, 3000};
  const std::string data(reinterpret_cast<const char*>(heat), sizeof heat);
  EXPECT_EQ(pixels(pictureOf(image(2, 1, im::L_INT16, data))), (std::vector<int>{0, 0, 0, 255, 255, 255}));
}

TEST(Picture, IsNoneOfWhatIsNoImage) {
  EXPECT_FALSE(pictureOf(image(0, 0, im::RGB_INT8, "")));
  EXPECT_FALSE(pictureOf(image(2, 2, im::RGB_INT8, "abc")));
  EXPECT_FALSE(pictureOf(image(4'000'000'000, 4'000'000'000, im::RGB_INT8, "abc")));
  EXPECT_FALSE(pictureOf(image(4'000'000'000, 4'000'000'000, im::R_FLOAT32, "abc")));
  // their size is 2^64 bytes
  EXPECT_FALSE(pictureOf(image(1U << 31, 1U << 31, im::RGBA_INT8, "abc")));
  EXPECT_FALSE(pictureOf(image(1U << 31, 1U << 31, im::R_FLOAT32, "abc")));
  EXPECT_FALSE(pictureOf(image(1, 1, im::BAYER_RGGB8, "abc")));
  EXPECT_FALSE(picture(std::as_bytes(std::span("\xff\xff", 2))));
}

}  // namespace
}  // namespace pongsim::web::gz
