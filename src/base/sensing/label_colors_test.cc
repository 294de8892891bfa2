#include "pongsim/sensing/label_colors.hh"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace pongsim::label_colors_test {
namespace {

using Segmentation = CameraSettings::Segmentation;

TEST(LabelColors, AreThoseOfFortress) {
  // Fortress draws them with what the standard library of GCC has by default
  for (const std::uint32_t number : {1U, 10U, 40U, 255U, 65'536U, 20U * 65'536 + 3}) {
    std::minstd_rand0 generator(number);
    std::uniform_int_distribution<int> channel(0, 255);
    LabelColor expected;
    for (std::uint8_t& each : expected) each = static_cast<std::uint8_t>(channel(generator));
    for (std::uint8_t& each : expected) each = each == 1 ? 255 : each;
    EXPECT_EQ(LabelPalette().colorOf(number), expected) << number;
  }
}

TEST(LabelColors, DifferFromEachOtherAndFromBlack) {
  LabelPalette palette;
  const LabelColor first = palette.colorOf(7), second = palette.colorOf(7);
  EXPECT_NE(first, second);
  EXPECT_NE(first, LabelColor());
  EXPECT_NE(second, LabelColor());
}

TEST(LabelColors, OfKindsAreTheSameForAllOfALabel) {
  const std::vector<SeenVisual> visuals{{"a", 40}, {"b", std::nullopt}, {"c", 40}, {"c", 30}, {"d", 0}};
  const std::vector<LabelLook> looks = labelLooks(visuals, Segmentation::kSemantic);
  ASSERT_EQ(looks.size(), 5U);
  EXPECT_EQ(looks[0].code, (LabelColor{40, 40, 40}));
  EXPECT_EQ(looks[0].color, LabelPalette().colorOf(40));
  EXPECT_EQ(looks[2].color, looks[0].color);
  EXPECT_EQ(looks[3].code, (LabelColor{30, 30, 30}));
  EXPECT_NE(looks[3].color, looks[0].color);
  for (const std::size_t background : {1, 4}) {
    EXPECT_EQ(looks[background].color, LabelColor());
    EXPECT_EQ(looks[background].code, LabelColor());
  }
}

TEST(LabelColors, OfInstancesCountOwnersBackwards) {
  std::vector<SeenVisual> visuals{{"box", 40}, {"box", 40}, {"box1", 40}, {"car", 40}, {"car", 30}};
  std::vector<LabelLook> looks = labelLooks(visuals, Segmentation::kPanoptic);
  ASSERT_EQ(looks.size(), 5U);
  // "car::", "box::", "box1::" is their descending order
  EXPECT_EQ(looks[3].code, (LabelColor{1, 0, 40}));
  EXPECT_EQ(looks[0].code, (LabelColor{2, 0, 40}));
  EXPECT_EQ(looks[1].code, looks[0].code);
  EXPECT_EQ(looks[2].code, (LabelColor{3, 0, 40}));
  EXPECT_EQ(looks[4].code, (LabelColor{1, 0, 30}));
  EXPECT_EQ(looks[2].color, LabelPalette().colorOf(40 * 65'536 + 3));
  EXPECT_NE(looks[0].color, looks[3].color);

  // the count of instances has 16 bits
  visuals.clear();
  for (int i = 0; i < 300; ++i) visuals.push_back({std::to_string(1000 + i), 5});
  looks = labelLooks(visuals, Segmentation::kPanoptic);
  EXPECT_EQ(looks.front().code, (LabelColor{300 % 256, 1, 5}));
  EXPECT_EQ(looks.back().code, (LabelColor{1, 0, 5}));
}

}  // namespace
}  // namespace pongsim::label_colors_test
