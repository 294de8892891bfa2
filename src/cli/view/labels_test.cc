#include "cli/view/labels.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "rendering/small_font.hh"
#include "support/cli/still_sight.hh"

namespace pongsim::cli {
namespace {

using rendering::kLetterHeight;
using rendering::kLetterWidth;
using rendering::SmallLetter;
using rendering::smallLetter;

constexpr std::uint8_t kGrey = 80;

/// A grey picture with labels in it.
class Labelled {
 public:
  Labelled(const std::vector<Label>& labels, std::uint32_t width, std::uint32_t height)
      : width_(width), height_(height), pixels_(std::size_t{3} * width * height, kGrey) {
    drawLabels(labels, width, height, pixels_);
  }

  /// @return Whether the text stands there, its upper left dot at that pixel, with dots of that many pixels.
  bool shows(const std::string& text, std::size_t left, std::size_t top, std::size_t dot) const {
    for (std::size_t i = 0; i < text.size(); ++i) {
      const SmallLetter letter = smallLetter(static_cast<unsigned char>(text[i]));
      for (std::size_t x = 0; x < kLetterWidth * dot; ++x) {
        for (std::size_t y = 0; y < kLetterHeight * dot; ++y) {
          const bool isDot = (letter[x / dot] >> (y / dot) & 1) != 0;
          const std::size_t column = left + i * (kLetterWidth + 1) * dot + x;
          if (column >= width_ || top + y >= height_) return false;
          if ((pixels_[3 * ((top + y) * width_ + column)] == 255) != isDot) return false;
        }
      }
    }
    return true;
  }

  std::size_t countOf(std::uint8_t value) const {
    return static_cast<std::size_t>(std::ranges::count(pixels_, value)) / 3;
  }

 private:
  std::size_t width_, height_;
  std::vector<std::uint8_t> pixels_;
};

TEST(Labels, StandAboveTheirPlaces) {
  // a panel of 13 by 9 pixels, one above the place
  const Labelled picture({{"ab", 20, 20}}, 40, 30);
  EXPECT_TRUE(picture.shows("ab", 15, 11, 1));
  EXPECT_EQ(picture.countOf(kGrey), 40U * 30 - 13 * 9);
}

TEST(Labels, GrowWithThePicture) { EXPECT_TRUE(Labelled({{"ab", 200, 200}}, 400, 600).shows("ab", 189, 182, 2)); }

TEST(Labels, MakeRoomForEachOther) {
  const Labelled picture({{"up", 20, 48}, {"down", 24, 50}}, 60, 60);
  EXPECT_TRUE(picture.shows("down", 13, 41, 1));
  EXPECT_TRUE(picture.shows("up", 15, 32, 1));
}

TEST(Labels, AreCutOffAtTheEdges) {
  const Labelled picture({{"wide name", 2, 3}, {"w", 39, 29}}, 40, 30);
  EXPECT_GT(picture.countOf(255), 0U);
  EXPECT_LT(picture.countOf(255), 60U);
}

TEST(Labels, HaveOneSignForEachLetterBeyondAscii) {
  const Labelled picture({{"\u00e9\u4e2d", 20, 20}}, 40, 30);
  EXPECT_TRUE(picture.shows("\n\n", 15, 11, 1));
}

/// Boxes with names.
class NamedBoxes final : public test::StillSight {
 public:
  explicit NamedBoxes(std::map<std::string, Eigen::AlignedBox3d> boxes) : boxes_(std::move(boxes)) {}
  std::vector<std::string> names() override {
    std::vector<std::string> names;
    for (const auto& [name, box] : boxes_) names.push_back(name);
    return names;
  }
  Eigen::AlignedBox3d bounds(const std::string& name) override { return boxes_.at(name); }

 private:
  std::map<std::string, Eigen::AlignedBox3d> boxes_;
};

TEST(Labels, AreThoseOfTheModelsInThePicture) {
  const auto boxAt = [](double x, double y, double z) {
    const Vector3 half = Vector3::Constant(0.5);
    return Eigen::AlignedBox3d(Vector3(x, y, z) - half, Vector3(x, y, z) + half);
  };
  NamedBoxes sight({{"ahead", boxAt(10, 1, -0.5)},
                    {"around", boxAt(0, 0, 0).merged(boxAt(20, 0, -1))},
                    {"ahead::part", boxAt(10, 0, 0)},
                    {"aside", boxAt(10, 20, 0)},
                    {"behind", boxAt(-10, 0, 0)},
                    {"empty", {}}});
  PictureView view;
  view.X_WorldEye.position = {0, 0, 1};
  const std::vector<Label> labels = labelsOf(sight, view);
  ASSERT_EQ(labels.size(), 2U);
  EXPECT_EQ(labels[0].text, "ahead");
  // the far edge of its top, at one of its ends
  EXPECT_NEAR(labels[0].column, 160 - 277 * 1 / 10.5, 277 * 0.5 / 10.5 + 1e-9);
  EXPECT_DOUBLE_EQ(labels[0].row, 120 + 277 / 10.5);
  EXPECT_EQ(labels[1].text, "around");
}

}  // namespace
}  // namespace pongsim::cli
