#include "pongsim/sensing/ray_scene.hh"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "pongsim/simulation.hh"

namespace pongsim {
namespace {

constexpr const char* kBoxAndBall = R"(<sdf version="1.9"><world name="w">
  <model name="box"><static>true</static><pose>4 0 0 0 0 0</pose><link name="l"><visual name="v">
    <visibility_flags>1</visibility_flags><geometry><box><size>2 2 2</size></box></geometry></visual></link></model>
  <model name="ball"><pose>0 5 0 0 0 0</pose><link name="l"><visual name="v"><visibility_flags>2</visibility_flags>
    <geometry><sphere><radius>1</radius></sphere></geometry></visual></link></model>
</world></sdf>)";

class RaySceneTest : public testing::Test {
 protected:
  RaySceneTest() {
    Diagnostics diagnostics;
    simulation_ = Simulation::fromText(kBoxAndBall, "world.sdf", {.loadSystems = false}, diagnostics);
    scene_ = std::make_unique<RayScene>(simulation_->world());
  }
  RayHit cast(const Ray& ray, double farthest = std::numeric_limits<double>::infinity(), std::uint32_t mask = ~0U) {
    Diagnostics diagnostics;
    std::array<RayHit, 1> hit;
    scene_->cast(std::array{ray}, farthest, mask, hit, diagnostics);
    EXPECT_TRUE(diagnostics.all().empty());
    return hit[0];
  }
  std::optional<LinkId> linkOf(const char* model) { return simulation_->world().model(model)->link("l")->id(); }

  std::unique_ptr<Simulation> simulation_;
  std::unique_ptr<RayScene> scene_;
};

TEST_F(RaySceneTest, FindsTheFirstSurfaceAndItsLink) {
  const RayHit box = cast({{0, 0, 0}, {1, 0, 0}}), ball = cast({{0, 0, 0}, {0, 1, 0}});
  EXPECT_NEAR(box.distance, 3, 1e-9);
  EXPECT_EQ(box.link, linkOf("box"));
  EXPECT_NEAR(ball.distance, 4, 1e-9);
  EXPECT_EQ(ball.link, linkOf("ball"));
  const RayHit nothing = cast({{0, 0, 0}, {0, 0, 1}});
  EXPECT_EQ(nothing.distance, INFINITY);
  EXPECT_EQ(nothing.link, std::nullopt);
}

TEST_F(RaySceneTest, KeepsToTheDistanceAndTheMask) {
  EXPECT_EQ(cast({{0, 0, 0}, {1, 0, 0}}, 2.9).link, std::nullopt);
  EXPECT_EQ(cast({{0, 0, 0}, {1, 0, 0}}, 10, 2).link, std::nullopt);
  EXPECT_EQ(cast({{0, 0, 0}, {1, 0, 0}}, 10, 1).link, linkOf("box"));
}

TEST_F(RaySceneTest, BeginsAnywhere) {
  EXPECT_NEAR(cast({{1e6, 0, 0}, {-1, 0, 0}}).distance, 1e6 - 5, 1e-6);
  EXPECT_EQ(cast({{1e300, 0, 0}, {-1, 0, 0}}).link, std::nullopt);
  EXPECT_EQ(cast({{NAN, 0, 0}, {-1, 0, 0}}).link, std::nullopt);
  // out of a body, whose surface is seen from outside only
  EXPECT_EQ(cast({{4, 0, 0}, {1, 0, 0}}).link, std::nullopt);
}

TEST_F(RaySceneTest, SeesWhatHasMovedAndWhatIsNew) {
  ASSERT_TRUE(simulation_->world().model("ball")->setPose({{0, 8, 0}, Quaternion::Identity()}));
  EXPECT_NEAR(cast({{0, 0, 0}, {0, 1, 0}}).distance, 7, 1e-9);
  ASSERT_TRUE(simulation_->remove(*simulation_->world().model("box")));
  EXPECT_EQ(cast({{0, 0, 0}, {1, 0, 0}}).link, std::nullopt);
}

}  // namespace
}  // namespace pongsim
