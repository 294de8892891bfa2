#include "rendering/paint.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "assets/images/picture_file.hh"
#include "support/rendering/drawn_world.hh"
#include "support/temp_folder.hh"

namespace pongsim::rendering {
namespace {

using description::PbrMetal;

/// Renders a white vertical wall 1 m ahead, lit by one lamp from the side and the front.
class PaintedWall : public test::Pictures {
 protected:
  /// @return A picture of one colour.
  description::Texture plain(std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
    const auto file = folder_.path() / (std::to_string(count_++) + ".png");
    EXPECT_FALSE(assets::writePicture(file, 1, 1, std::array{red, green, blue}));
    return {file.string(), file};
  }
  description::Texture broken() {
    const auto file = folder_.write("broken.jpg", "no picture");
    return {file.string(), file};
  }

  /// @param lampDirection Direction of the lamp's light.
  /// @param emitted Emissive colour of the wall.
  std::vector<std::uint8_t> draw(const PbrMetal& metal, const Vector3& lampDirection = {1, 0, 0},
                                 const description::Color& emitted = {0, 0, 0, 1}) {
    test::DrawnWorld world;
    description::Visual& wall = world.add(description::Box{{2, 6, 6}}, {{2, 0, 0}, Quaternion::Identity()});
    wall.position.line = 7;
    wall.material.emplace();
    wall.material->diffuse = wall.material->ambient = wall.material->specular = {1, 1, 1, 1};
    wall.material->emissive = emitted;
    wall.material->metal = metal;
    world.description().scene.ambient = {0, 0, 0, 1};
    if (!lampDirection.isZero()) {
      description::Light& lamp = world.description().lights.emplace_back();
      lamp.name = "lamp";
      lamp.type = description::LightType::kDirectional;
      lamp.direction = lampDirection.normalized();
      lamp.diffuse = lamp.specular = {0.8F, 0.8F, 0.8F, 1};
      lamp.castsShadows = false;
    }
    world.start();
    warnings_ = world.warnings();
    return world.colors(test::view(9, 9, 9));
  }

  /// @return Red in the centre of the image.
  static int middle(const std::vector<std::uint8_t>& pixels) { return pixels[std::size_t{3} * 40]; }

  /// @return The largest difference between two images.
  static int difference(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    int largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
  }

  pongsim::test::TempFolder folder_;
  std::vector<Diagnostic> warnings_;

 private:
  int count_ = 0;
};

/// Rough and not metallic, so that only diffuse light counts.
PbrMetal chalk() {
  PbrMetal metal;
  metal.metalness = 0;
  metal.roughness = 1;
  return metal;
}

TEST_F(PaintedWall, LeansAsItsNormalsTell) {
  const auto brightness = [this](const description::Texture& normals, const Vector3& lampDirection) {
    PbrMetal metal = chalk();
    metal.maps.normal = normals;
    return middle(draw(metal, lampDirection));
  };
  // normals tilted by 45 degrees: red to the right of the image, green up
  const auto right = plain(218, 128, 218), left = plain(38, 128, 218), up = plain(128, 218, 218);
  const auto down = plain(128, 38, 218), flat = plain(128, 128, 255);
  // seen along x, y is to the left
  const Vector3 fromTheLeft(1, -1, 0), fromAbove(1, 0, -1);
  for (const Vector3& direction : {fromTheLeft, fromAbove}) {
    const int even = brightness({}, direction);
    EXPECT_NEAR(brightness(flat, direction), even, 2);
    const auto& towards = direction == fromTheLeft ? left : up;
    const auto& away = direction == fromTheLeft ? right : down;
    EXPECT_GT(brightness(towards, direction), even + 15);
    EXPECT_LT(brightness(away, direction), even - 60);
  }
  // the side facing the lamp looks like the least tilted wall
  EXPECT_NEAR(brightness(up, fromTheLeft), brightness(down, fromTheLeft), 3);
}

TEST_F(PaintedWall, IsAsRoughAndMetallicAsItsMapsTellByItsNumbers) {
  // the lamp shines along the line of sight, where a smooth wall has its highlight
  PbrMetal numbers = chalk();
  for (const auto& [roughness, metalness] : {std::pair(0.4, 0.2), std::pair(0.2, 0.8)}) {
    numbers.roughness = roughness;
    numbers.metalness = metalness;
    const auto expected = draw(numbers);
    PbrMetal maps;
    // times 0.8, of the red in it only
    maps.roughness = maps.metalness = 0.8;
    maps.roughnessMap = plain(static_cast<std::uint8_t>(std::lround(roughness / 0.8 * 255)), 7, 99);
    maps.metalnessMap = plain(static_cast<std::uint8_t>(std::lround(metalness / 0.8 * 255)), 80, 3);
    EXPECT_LE(difference(draw(maps), expected), 2) << roughness;
    EXPECT_GT(difference(draw(chalk()), expected), 10) << roughness;
    // one at a time: without the other map, its number counts alone
    maps.metalnessMap = {};
    maps.metalness = metalness;
    EXPECT_LE(difference(draw(maps), expected), 2) << roughness;
  }
}

TEST_F(PaintedWall, ShinesAsItsMapTells) {
  PbrMetal metal = chalk();
  metal.maps.emissive = plain(200, 0, 50);
  const auto colorOf = [](const std::vector<std::uint8_t>& pixels) {
    return std::vector<int>(pixels.begin() + 120, pixels.begin() + 123);
  };
  const Vector3 dark = Vector3::Zero();
  EXPECT_EQ(colorOf(draw(metal, dark)), (std::vector<int>{200, 0, 50}));
  // multiplied by the material's own colour
  EXPECT_EQ(colorOf(draw(metal, dark, {1, 1, 0, 1})), (std::vector<int>{200, 0, 0}));
  EXPECT_TRUE(warnings_.empty());
}

TEST_F(PaintedWall, IsDrawnWithoutAMapThatIsBroken) {
  const auto without = draw(chalk());
  for (description::Texture PbrMetal::*map : {&PbrMetal::roughnessMap, &PbrMetal::metalnessMap}) {
    PbrMetal metal = chalk();
    metal.*map = broken();
    EXPECT_EQ(draw(metal), without);
    ASSERT_EQ(warnings_.size(), 1U);
  }
  PbrMetal metal = chalk();
  // a file used twice is reported once
  metal.maps.normal = metal.maps.emissive = broken();
  EXPECT_EQ(draw(metal), without);
  ASSERT_EQ(warnings_.size(), 1U);
  EXPECT_EQ(warnings_[0].severity, Severity::kWarning);
  EXPECT_EQ(warnings_[0].position.line, 7);
  EXPECT_NE(warnings_[0].message.find("broken.jpg' is not a PNG, JPEG, TGA or BMP image"), std::string::npos)
      << warnings_[0].message;
}

}  // namespace
}  // namespace pongsim::rendering
