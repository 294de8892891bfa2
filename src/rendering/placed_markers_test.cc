#include "rendering/placed_markers.hh"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "support/rendering/drawn_world.hh"

namespace pongsim::rendering {
namespace {

using MarkerType = world::Marker::Type;

constexpr std::size_t kEdge = 40;

/// A world in which markers are drawn, 2 m ahead of the eye, where a metre is 20 pixels.
class DrawnMarkers : public test::Pictures {
 protected:
  world::Marker& add(MarkerType type, const Vector3& position = {2, 0, 0}) {
    auto& marker = markers_.emplace_back();
    marker.type = type;
    marker.X_ParentMarker.position = position;
    marker.color = {0, 1, 0, 1};
    return marker;
  }

  static PictureView sight() {
    PictureView view = test::view(kEdge, kEdge, 40);
    view.antiAliasing = 1;
    return view;
  }

  std::vector<std::uint8_t> colors() {
    if (!isStarted_) world_.start();
    isStarted_ = true;
    MarkerList list;
    for (const world::Marker& marker : markers_) list.push_back(std::make_shared<const world::Marker>(marker));
    world_.show(list);
    return world_.colors(sight());
  }

  /// @return How many pixels have the colour.
  static std::size_t count(const std::vector<std::uint8_t>& pixels, std::array<int, 3> color) {
    std::size_t number = 0;
    for (std::size_t i = 0; i < pixels.size(); i += 3) {
      number += pixels[i] == color[0] && pixels[i + 1] == color[1] && pixels[i + 2] == color[2] ? 1 : 0;
    }
    return number;
  }

  test::DrawnWorld world_;
  std::vector<world::Marker> markers_;
  bool isStarted_ = false;
};

constexpr std::array<int, 3> kGreen{0, 255, 0};

TEST_F(DrawnMarkers, HaveTheirColourWithoutLight) {
  add(MarkerType::kBox).scale = {0.1, 0.5, 1};
  const auto pixels = colors();
  // its front is 1.95 m away: 0.5 and 1 m are 10.3 and 20.5 pixels
  EXPECT_NEAR(static_cast<double>(count(pixels, kGreen)), 10.3 * 20.5, 20);
}

TEST_F(DrawnMarkers, AreHiddenByWhatIsBeforeThemAndHideWhatIsBehind) {
  world_.addShining(description::Box{{0.1, 4, 4}}, {3, 0, 0}, {1, 0, 0, 1});
  add(MarkerType::kBox).scale = {0.1, 0.5, 1};
  EXPECT_GT(count(colors(), kGreen), 100U);
  markers_[0].X_ParentMarker.position.x() = 4;
  EXPECT_EQ(count(colors(), kGreen), 0U);
}

TEST_F(DrawnMarkers, ShineThroughAsTheirOpacitySays) {
  world_.addShining(description::Box{{0.1, 4, 4}}, {3, 0, 0}, {1, 0, 0, 1});
  add(MarkerType::kBox).color = {0, 1, 0, 0.5F};
  const auto pixels = colors();
  const std::size_t middle = 3 * (kEdge / 2 * kEdge + kEdge / 2);
  EXPECT_GT(pixels[middle], 30);
  EXPECT_LT(pixels[middle], 200);
  EXPECT_GT(pixels[middle + 1], 180) << "the near side of the box shines through its far side";
}

TEST_F(DrawnMarkers, AreLinesAndPointsOnePixelWide) {
  add(MarkerType::kLineList).points = {{0, 0.5, 0.0125}, {0, -0.5, 0.0125}};
  EXPECT_NEAR(static_cast<double>(count(colors(), kGreen)), 20, 1);
  markers_[0].type = MarkerType::kPoints;
  EXPECT_EQ(count(colors(), kGreen), 2U);
}

TEST_F(DrawnMarkers, AreTextThatTurnsTowardsTheEye) {
  world::Marker& text = add(MarkerType::kText);
  text.text = "#";
  text.scale.setConstant(1.4);
  const std::size_t upright = count(colors(), kGreen);
  // 20 dots of 4 by 4 pixels
  EXPECT_NEAR(static_cast<double>(upright), 20 * 16, 40);
  markers_[0].X_ParentMarker.rotation = Eigen::AngleAxisd(1.5, Vector3::UnitZ());
  EXPECT_EQ(count(colors(), kGreen), upright);
}

TEST_F(DrawnMarkers, HaveADepth) {
  add(MarkerType::kBox).scale = {0.1, 0.5, 1};
  colors();
  const std::vector<float> depths = world_.depths(sight());
  EXPECT_NEAR(depths[kEdge / 2 * kEdge + kEdge / 2], 1.95, 1e-4);
}

TEST_F(DrawnMarkers, AreWhereTheirParentIs) {
  world_.add(description::Box{{0.1, 0.1, 0.1}}, {{0, 0, 1}, Quaternion::Identity()}).X_LinkVisual.position = {0, 0, 3};
  EXPECT_EQ(count(colors(), kGreen), 0U);
  world_.move(0, {1, 0, 0});
  EXPECT_EQ(world_.parentPose("m1")->position, Vector3(1, 0, 0));
  EXPECT_EQ(world_.parentPose("m1::l")->position, Vector3(1, 0, 0));
  EXPECT_EQ(world_.parentPose("m1::l::v")->position, Vector3(1, 0, 3));
  EXPECT_EQ(world_.parentPose("")->position, Vector3(0, 0, 0));
  for (const char* nobody : {"nobody", "m1::x", "m1::l::x", "m1::x::v", "::"}) {
    EXPECT_FALSE(world_.parentPose(nobody)) << nobody;
  }
  add(MarkerType::kBox, {1, 0, 0}).parent = "m1::l";
  EXPECT_GT(count(colors(), kGreen), 100U);
  markers_[0].parent = "nobody";
  EXPECT_EQ(count(colors(), kGreen), 0U);
}

}  // namespace
}  // namespace pongsim::rendering
