#include "cli/view/painter.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "pongsim/sensing/label_colors.hh"
#include "support/cli/still_sight.hh"

namespace pongsim::cli {
namespace {

/// A picture of three pixels with given values.
class GivenValues final : public test::StillSight {
 public:
  void drawDepths(const PictureView&, std::span<float> depths) override { std::ranges::copy(values, depths.begin()); }
  void drawTemperatures(const PictureView&, std::span<float> temperatures) override {
    std::ranges::copy(values, temperatures.begin());
  }
  void drawNumbers(const PictureView&, std::span<std::uint32_t> pixels) override {
    std::ranges::copy(numbers, pixels.begin());
  }
  std::span<const SeenVisual> visuals() override { return seen; }

  std::vector<float> values;
  std::vector<std::uint32_t> numbers;
  std::vector<SeenVisual> seen;
};

std::vector<int> picture(Painter& painter, Sight& sight) {
  std::vector<std::uint8_t> pixels(9);
  painter.draw(sight, {}, pixels);
  return {pixels.begin(), pixels.end()};
}

TEST(Painter, ShowsDistancesByTheirInverse) {
  GivenValues sight;
  Painter painter(PictureKind::kDepths);
  sight.values = {2, 4, INFINITY};
  EXPECT_EQ(picture(painter, sight), (std::vector{255, 255, 255, 128, 128, 128, 0, 0, 0}));
  EXPECT_EQ(painter.legend(), "white is 2 m away, half as bright twice as far");
  // the colours of a video mean the same all the time
  sight.values = {1, 8, INFINITY};
  EXPECT_EQ(picture(painter, sight), (std::vector{255, 255, 255, 64, 64, 64, 0, 0, 0}));
}

TEST(Painter, SaysWhereNothingIsNear) {
  GivenValues sight;
  Painter painter(PictureKind::kDepths);
  sight.values = {INFINITY, INFINITY, INFINITY};
  EXPECT_EQ(picture(painter, sight), std::vector<int>(9));
  EXPECT_EQ(painter.legend(), "nothing is in the picture");
}

TEST(Painter, ShowsTemperaturesFromTheColdestToTheHottest) {
  GivenValues sight;
  Painter painter(PictureKind::kTemperatures);
  sight.values = {280, 320.456F, 300.228F};
  EXPECT_EQ(picture(painter, sight), (std::vector{0, 0, 0, 255, 255, 255, 128, 128, 128}));
  EXPECT_EQ(painter.legend(), "black is 280 K, white 320.46 K");
  sight.values = {270, 400, 280};
  EXPECT_EQ(picture(painter, sight), (std::vector{0, 0, 0, 255, 255, 255, 0, 0, 0}));
}

TEST(Painter, IsBlackWhereAllHaveOneTemperature) {
  GivenValues sight;
  Painter painter(PictureKind::kTemperatures);
  sight.values = {290, 290, 290};
  EXPECT_EQ(picture(painter, sight), std::vector<int>(9));
}

TEST(Painter, ShowsLabelsAsSegmentationCamerasDo) {
  GivenValues sight;
  Painter painter(PictureKind::kLabels);
  sight.numbers = {0, 1, 2};
  sight.seen = {{"box", 7}, {"ball", std::nullopt}};
  const LabelColor color = LabelPalette().colorOf(7);
  EXPECT_EQ(picture(painter, sight), (std::vector<int>{0, 0, 0, color[0], color[1], color[2], 0, 0, 0}));
  EXPECT_EQ(painter.legend(), "");
}

}  // namespace
}  // namespace pongsim::cli
