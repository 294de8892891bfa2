#include "rendering/billboards.hh"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "support/png_file.hh"
#include "support/rendering/drawn_world.hh"
#include "support/temp_folder.hh"

namespace pongsim::rendering {
namespace {

using test::DrawnWorld;
using test::Pictures;
using test::view;
using Rgb = std::vector<int>;

/// @return The colour of a pixel of a picture of 41 by 41.
Rgb shownAt(const std::vector<std::uint8_t>& picture, int column, int row) {
  const auto* first = &picture[3 * static_cast<std::size_t>(41 * row + column)];
  return {first[0], first[1], first[2]};
}

/// A black wall behind particles that do not become larger.
class BillboardsTest : public Pictures {
 protected:
  BillboardsTest() {
    world_.addShining(description::Box{{0.1, 20, 20}}, {9, 0, 0}, {0, 0, 0, 1});
    emitter_ = &world_.addEmitter();
    eye_.antiAliasing = 1;
  }

  DrawnWorld world_;
  description::ParticleEmitter* emitter_ = nullptr;
  PictureView eye_ = view(41, 41, 40);
};

TEST_F(BillboardsTest, CoverTheirSizeAroundTheirPlace) {
  emitter_->particleSize = {1, 2, 1};
  world_.start();
  world_.show({4, 0, 0}, 0);
  const auto picture = world_.colors(eye_);
  // 10 pixels wide and 20 high
  for (const int column : {16, 20, 24}) EXPECT_EQ(shownAt(picture, column, 20), (Rgb{255, 255, 255}));
  for (const int column : {14, 26}) EXPECT_EQ(shownAt(picture, column, 20), (Rgb{0, 0, 0}));
  for (const int row : {11, 29}) EXPECT_EQ(shownAt(picture, 20, row), (Rgb{255, 255, 255}));
  for (const int row : {9, 31}) EXPECT_EQ(shownAt(picture, 20, row), (Rgb{0, 0, 0}));
}

TEST_F(BillboardsTest, AreParallelToTheImage) {
  world_.start();
  world_.show({4, 0, 0}, 0);
  eye_.X_WorldEye.rotation = fromRollPitchYaw(0.785398, 0, 0);
  const auto picture = world_.colors(eye_);
  // its corner, which a camera that does not roll sees elsewhere
  EXPECT_EQ(shownAt(picture, 24, 24), (Rgb{255, 255, 255}));
}

TEST_F(BillboardsTest, GoFromTheirFirstColourToTheLastAndAreBlended) {
  emitter_->colorStart = {1, 0, 0, 1};
  emitter_->colorEnd = {0, 1, 0, 1};
  world_.start();
  world_.show({4, 0.5, 0}, 0);
  world_.show({4, -0.5, 0}, 1);
  auto picture = world_.colors(eye_);
  EXPECT_EQ(shownAt(picture, 15, 20), (Rgb{255, 0, 0}));
  EXPECT_EQ(shownAt(picture, 25, 20), (Rgb{0, 255, 0}));
}

TEST_F(BillboardsTest, AreBlendedWithWhatIsBehind) {
  emitter_->colorStart = emitter_->colorEnd = {1, 1, 1, 0.5F};
  emitter_->material.emplace().diffuse = {1, 0, 0, 1};
  world_.start();
  world_.show({4, 0, 0}, 0);
  // 0.5 in linear light
  const Rgb shown = shownAt(world_.colors(eye_), 20, 20);
  EXPECT_NEAR(shown[0], 188, 1);
  EXPECT_EQ(shown[1], 0);
}

TEST_F(BillboardsTest, AreBlendedFromTheFarthest) {
  emitter_->colorStart = {1, 0, 0, 1};
  emitter_->colorEnd = {0, 0, 1, 1};
  world_.start();
  world_.show({3, 0, 0}, 0);
  world_.show({4, 0, 0}, 1);
  EXPECT_EQ(shownAt(world_.colors(eye_), 20, 20), (Rgb{255, 0, 0}));
}

TEST_F(BillboardsTest, AreHiddenByWhatIsNearer) {
  world_.start();
  world_.show({10, 0, 0}, 0);
  EXPECT_EQ(shownAt(world_.colors(eye_), 20, 20), (Rgb{0, 0, 0}));
}

TEST_F(BillboardsTest, ShowTheirImageAndTheColoursOfAnother) {
  const pongsim::test::TempFolder folder;
  std::vector<std::uint8_t> halves(std::size_t{3} * 64 * 64, 255);
  for (std::size_t i = 0; i < halves.size(); ++i) {
    if (i / 3 % 64 >= 32) halves[i] = 0;
  }
  assets::writePicture(folder.path() / "left.png", 64, 64, halves);
  assets::writePicture(folder.path() / "colors.png", 3, 1, std::vector<std::uint8_t>{255, 0, 0, 0, 255, 0, 0, 0, 255});
  emitter_->material.emplace().diffuse = {1, 1, 1, 1};
  emitter_->material->metal.emplace().maps.albedo.file = folder.path() / "left.png";
  emitter_->colorRange.file = folder.path() / "colors.png";
  world_.start();
  EXPECT_EQ(world_.warnings().size(), 0U);
  world_.show({4, 0, 0}, 0.5);
  const auto picture = world_.colors(eye_);
  EXPECT_EQ(shownAt(picture, 16, 20), (Rgb{0, 255, 0}));
  EXPECT_EQ(shownAt(picture, 24, 20), (Rgb{0, 0, 0}));
}

TEST_F(BillboardsTest, WarnOfImagesThatCantBeRead) {
  emitter_->name = "smoke";
  emitter_->colorRange.file = "/nowhere/colors.png";
  world_.start();
  ASSERT_EQ(world_.warnings().size(), 1U);
  EXPECT_NE(world_.warnings()[0].message.find("cameras will not see it on particles of 'smoke'"), std::string::npos);
}

}  // namespace
}  // namespace pongsim::rendering
