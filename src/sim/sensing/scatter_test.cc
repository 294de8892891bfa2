#include "sim/sensing/scatter.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace pongsim::sim {
namespace {

using namespace std::chrono_literals;
constexpr float kNothing = std::numeric_limits<float>::infinity();

/// A particle of 2 m ahead of a sensor at the origin, at 5 m.
class ScatterTest : public testing::Test {
 protected:
  ScatterTest() {
    description::Model& model = world_.models.emplace_back();
    model.name = "m";
    model.canonicalLink = "l";
    description::Link& link = model.links.emplace_back();
    link.name = "l";
    description::ParticleEmitter& emitter = link.emitters.emplace_back();
    emitter.particleSize = {2, 2, 2};
    emitter.scatterRatio = 1;
    access_ = std::make_unique<Access>(world_);
    view_.width = view_.height = 40;
    view_.fx = view_.fy = 40;
    view_.cx = view_.cy = 20;
    view_.far = 50;
    cloud().particles.push_back({{5, 0, 0}, Vector3::Zero(), 0s, 10s});
  }
  world::Emitter& cloud() { return access_->particlesNow().emitters().at(0); }

  /// @return The depths, where a wall was at a depth.
  std::vector<float> depths(float wall) {
    std::vector<float> depths(std::size_t{view_.width} * view_.height, wall);
    Scatter(*access_, "camera").apply(view_, depths);
    return depths;
  }
  /// @return Ranges of beams one degree apart, from 30 degrees to the right, where a wall was at a range.
  std::vector<double> ranges(double wall) {
    std::vector<Vector3> directions;
    for (int i = -30; i <= 30; ++i) directions.emplace_back(std::cos(i * M_PI / 180), std::sin(i * M_PI / 180), 0);
    std::vector<Echo> echoes(directions.size(), Echo{wall, 7});
    Scatter(*access_, "lidar").apply({}, directions, 0.1, 50, echoes);
    std::vector<double> ranges;
    for (const Echo& echo : echoes) ranges.push_back(echo.range);
    return ranges;
  }

  description::World world_;
  std::unique_ptr<Access> access_;
  PictureView view_;
};

TEST_F(ScatterTest, IsInTheEllipseOfAParticleAndBehindItsSurface) {
  const std::vector<float> seen = depths(40);
  // 8 pixels around the centre
  int inside = 0;
  for (int row = 0; row < 40; ++row) {
    for (int column = 0; column < 40; ++column) {
      const float depth = seen[static_cast<std::size_t>(40 * row + column)];
      const double distance = std::hypot(row + 0.5 - 20, column + 0.5 - 20);
      if (distance > 8) {
        EXPECT_EQ(depth, 40) << row << " " << column;
        continue;
      }
      ++inside;
      EXPECT_GE(depth, 5 - 1e-5F);
      EXPECT_LT(depth, 40);
    }
  }
  EXPECT_GT(inside, 190);
}

TEST_F(ScatterTest, HasTheSpreadOfFortress) {
  view_.width = view_.height = 400;
  view_.fx = view_.fy = 400;
  view_.cx = view_.cy = 200;
  double sum = 0;
  int count = 0;
  for (const float depth : depths(kNothing)) {
    if (depth == kNothing) continue;
    sum += (static_cast<double>(depth) - 5) * (static_cast<double>(depth) - 5);
    ++count;
  }
  // the box around the particle is 2 m long, a quarter of it 0.5 m; E(3 n^2) = 3 (0.5^2 + the mean's square), where the
  // mean is r^2 / 4 with r evenly distributed from -0.5 to 0.5; beams are up to 2 % slanted
  EXPECT_GT(count, 19'000);
  EXPECT_NEAR(sum / count, 3 * (0.25 + 1.0 / 16 / 80), 0.03);
}

TEST_F(ScatterTest, HitsTheShareOfBeamsThatTheRatioSays) {
  view_.width = view_.height = 400;
  view_.fx = view_.fy = 400;
  view_.cx = view_.cy = 200;
  cloud().now.scatterRatio = 0.25;
  const std::vector<float> seen = depths(kNothing);
  const auto hits = std::ranges::count_if(seen, [](float depth) { return depth != kNothing; });
  EXPECT_NEAR(static_cast<double>(hits), 0.25 * M_PI * 80 * 80, 300);
}

TEST_F(ScatterTest, IsNotBehindOtherThings) {
  for (const float depth : depths(4.5F)) EXPECT_EQ(depth, 4.5F);
  for (const float depth : depths(5.2F)) EXPECT_LE(depth, 5.2F);
  for (const double range : ranges(4.5)) EXPECT_EQ(range, 4.5);
}

TEST_F(ScatterTest, OfBeamsIsWithinTheAngleOfTheParticle) {
  const std::vector<double> seen = ranges(std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const double angle = (static_cast<double>(i) - 30) * M_PI / 180;
    if (std::abs(std::tan(angle)) > 0.2) {
      EXPECT_TRUE(std::isinf(seen[i])) << i;
    } else {
      EXPECT_GE(seen[i], 5 / std::cos(angle) - 1e-9) << i;
    }
  }
}

TEST_F(ScatterTest, DependsOnSeedTimeAndSensorAlone) {
  const std::vector<float> first = depths(kNothing);
  EXPECT_EQ(depths(kNothing), first);
  access_->state.time = 1s;
  EXPECT_NE(depths(kNothing), first);
  access_->state.time = 0s;
  access_->particles.setSeed(5);
  EXPECT_NE(depths(kNothing), first);
}

TEST_F(ScatterTest, IsNotAroundACameraInAParticle) {
  cloud().particles[0].start = {0, 0, 0};
  for (const float depth : depths(40)) EXPECT_EQ(depth, 40);
  for (const double range : ranges(40)) EXPECT_EQ(range, 40);
}

}  // namespace
}  // namespace pongsim::sim
