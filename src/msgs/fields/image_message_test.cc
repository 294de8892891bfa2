#include "msgs/fields/image_message.hh"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "pongsim/message.hh"

namespace pongsim::msgs {
namespace {

struct ImageCase {
  const char* text;
  std::vector<std::uint8_t> pixels;
};

TEST(ImagePixels, AreColorsWhateverTheFormat) {
  const ImageCase cases[] = {
      {R"(width: 2, height: 1, pixel_format_type: RGB_INT8, data: "\001\002\003\004\005\006")", {1, 2, 3, 4, 5, 6}},
      {R"(width: 1, height: 1, pixel_format_type: BGR_INT8, data: "\001\002\003")", {3, 2, 1}},
      {R"(width: 1, height: 2, pixel_format_type: L_INT8, data: "\007\310")", {7, 7, 7, 200, 200, 200}},
      {R"(width: 1, height: 1, pixel_format_type: L_INT16, data: "\377\100")", {64, 64, 64}},
      // 1 m, 3 m, infinite
      {R"(width: 3, height: 1, pixel_format_type: R_FLOAT32, data: "\000\000\200\077\000\000\100\100\000\000\200\177")",
       {255, 255, 255, 40, 40, 40, 0, 0, 0}},
  };
  for (const auto& [text, pixels] : cases) {
    const MessagePointer message = newMessage("ignition.msgs.Image");
    parseMessage(text, *message);
    const std::optional<ImagePixels> found = pixelsOf(*message);
    ASSERT_TRUE(found) << text;
    EXPECT_EQ(found->pixels, pixels) << text;
  }
}

TEST(ImagePixels, AreNothingWhereAnImageIsNotWhatItSays) {
  for (const char* text : {"", "width: 1, height: 1, pixel_format_type: RGB_INT8, data: '12'",
                           "width: 0, height: 5, pixel_format_type: RGB_INT8",
                           "width: 4000000000, height: 4000000000, pixel_format_type: L_INT16, data: '12'",
                           "width: 1, height: 1, pixel_format_type: BAYER_RGGB8, data: '1'"}) {
    const MessagePointer message = newMessage("ignition.msgs.Image");
    parseMessage(text, *message);
    EXPECT_FALSE(pixelsOf(*message)) << text;
  }
}

}  // namespace
}  // namespace pongsim::msgs
