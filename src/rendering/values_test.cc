#include "rendering/values.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "support/rendering/drawn_world.hh"

namespace pongsim::rendering {
namespace {

using test::DrawnWorld;
using test::Pictures;
using test::view;

TEST(AirTemperatures, AreThoseOfFortress) {
  description::Atmosphere air;
  air.temperature = 300;
  air.temperatureGradient = 0.1;
  // of Fortress's example: "a temperature range of ~11.5 kelvin"
  PictureView eye = view(320, 240, 160 / std::tan(1.047 / 2));
  eye.far = 100;
  AirTemperatures range = airTemperatures(air, eye);
  EXPECT_NEAR(range.hottest - range.coldest, 0.1 * std::tan(1.047 / 2) * 200, 1e-9);
  EXPECT_NEAR((range.hottest + range.coldest) / 2, 300, 1e-9);
  // a higher image than wide, of which Fortress divides by zero
  eye = view(240, 320, 100);
  eye.far = 100;
  range = airTemperatures(air, eye);
  EXPECT_NEAR(range.hottest - range.coldest, 24, 1e-9);
  eye.far = std::numeric_limits<double>::infinity();
  range = airTemperatures(air, eye);
  EXPECT_EQ(range.coldest, 300);
  EXPECT_EQ(range.hottest, 300);
}

TEST_F(Pictures, TellVisualsApartToThePixel) {
  DrawnWorld world;
  // the transparent one is in front of the others, and one is hidden
  world.addShining(description::Box{{1, 40, 40}}, {20, 0, 0}, {});
  world.addShining(description::Box{{1, 1, 1}}, {30, 0, 0}, {});
  world.addShining(description::Box{{2, 2, 2}}, {6, 0, 0}, {}).transparency = 0.7;
  world.start();
  const PictureView eye = view(64, 48, 50);
  const std::vector<std::uint32_t> numbers = world.numbers(eye);
  for (std::uint32_t row = 0; row < eye.height; ++row) {
    for (std::uint32_t column = 0; column < eye.width; ++column) {
      const double right = std::abs(column + 0.5 - eye.cx) / eye.fx, down = std::abs(row + 0.5 - eye.cy) / eye.fy;
      // its face is 5 m ahead, and 1 m high and wide to each side
      const bool isInFront = right < 1 / 5.0 && down < 1 / 5.0;
      EXPECT_EQ(numbers[row * eye.width + column], isInFront ? 3U : 1U) << row << ' ' << column;
    }
  }
}

TEST_F(Pictures, TellTemperatures) {
  DrawnWorld world;
  world.description().environment.atmosphere.temperature = 290;
  world.addShining(description::Box{{1, 1, 1}}, {5, 2, 0}, {}).heat = description::Heat{.temperature = 350.25};
  // without heat of their own: the brighter the warmer
  world.addShining(description::Box{{1, 1, 1}}, {5, 0, 0}, {}).material->diffuse = {0.2F, 0.6F, 1, 1};
  world.start();
  const PictureView eye = view(90, 9, 50);
  const std::vector<float> temperatures = world.temperatures(eye, {280, 300});
  const auto at = [&](double y) { return temperatures[4 * 90 + static_cast<std::size_t>(45 - 50 * y / 4.5)]; };
  EXPECT_FLOAT_EQ(at(2), 350.25F);
  EXPECT_NEAR(at(0), 280 + 20 * (0.2 * 0.299 + 0.6 * 0.587 + 0.114), 1e-4);
  EXPECT_FLOAT_EQ(at(-2), 280);
}

}  // namespace
}  // namespace pongsim::rendering
