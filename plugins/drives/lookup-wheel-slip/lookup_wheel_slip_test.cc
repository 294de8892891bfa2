#include <gtest/gtest.h>
#include <ignition/msgs/twist.pb.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "pongsim/physical_properties.hh"
#include "support/example_world.hh"
#include "support/fortress_worlds.hh"
#include "support/going_on.hh"
#include "support/running_world.hh"

namespace pongsim::lookup_wheel_slip_test {
namespace {

using test::replaced;
using test::RunningWorld;

std::filesystem::path folder() { return test::projectFolder() / "plugins/drives/lookup-wheel-slip"; }

/// The example's models, with the map's full path.
std::string models() {
  return replaced(test::modelsOf("plugins/drives/lookup-wheel-slip/lookup_wheel_slip.sdf"), "<slip_map>",
                  "<slip_map>" + folder().string() + "/");
}

void drive(RunningWorld& world, double speed) {
  ignition::msgs::Twist twist;
  twist.mutable_linear()->set_x(speed);
  world.tell("/model/cart/cmd_vel", twist);
}

Collision rim(RunningWorld& world, const char* wheel) { return world.model("cart").link(wheel)->collisions()[0]; }

/// Moves the cart, and drives it until its wheels turn as commanded.
void driveFrom(RunningWorld& world, double x, double y) {
  ASSERT_TRUE(world.model("cart").setPose(Pose{Vector3(x, y, 0), Quaternion::Identity()}));
  drive(world, 0.6);
  world.step(500);
}

TEST(LookupWheelSlip, LeavesNominalGroundAsItIs) {
  RunningWorld world("<gravity>-1 0 -9.8</gravity>" + models());
  driveFrom(world, -2, 1);
  EXPECT_EQ(rim(world, "front_left").slip(), std::pair(0.0, 0.0));
  EXPECT_EQ(PhysicalProperties(world.simulation().world()).surface(rim(world, "front_left")).friction, 1);
}

// the map's colours: 100 more green on the left; 10 more red and 100 less blue on the right
TEST(LookupWheelSlip, SlipsByTheColourOfTheGround) {
  RunningWorld world("<gravity>-1 0 -9.8</gravity>" + models());
  const double scale = 0.6 / 19.6;
  driveFrom(world, 1.5, 1.5);
  EXPECT_NEAR(rim(world, "front_left").slip().first, 0, 1e-12);
  EXPECT_NEAR(rim(world, "front_left").slip().second, 100 * 0.01 * scale, 2e-3 * scale);
  EXPECT_EQ(PhysicalProperties(world.simulation().world()).surface(rim(world, "back_right")).friction, 1);
  driveFrom(world, 1.5, -1.5);
  EXPECT_NEAR(rim(world, "back_left").slip().first, 10 * 0.05 * scale, 2e-3 * scale);
  EXPECT_NEAR(rim(world, "back_left").slip().second, 0, 1e-12);
  const PhysicalProperties::Surface surface =
      PhysicalProperties(world.simulation().world()).surface(rim(world, "back_left"));
  EXPECT_NEAR(surface.friction, 0.5, 1e-12);
  EXPECT_NEAR(surface.friction2, 0.5, 1e-12);
  // outside the map all stays
  driveFrom(world, 9, 9);
  EXPECT_NEAR(rim(world, "back_left").slip().first, 10 * 0.05 * scale, 2e-3 * scale);
}

TEST(LookupWheelSlip, NothingFallsBelowZero) {
  RunningWorld world(replaced(models(), "<friction_delta>0.005", "<friction_delta>0.1"));
  driveFrom(world, 1.5, -1.5);
  EXPECT_EQ(PhysicalProperties(world.simulation().world()).surface(rim(world, "front_left")).friction, 0);
}

// slip / speed of the rim = compliance * force / load; a wheel holds a quarter of what pulls the cart back
TEST(LookupWheelSlip, SlowsACartThatComesToSlipperyGround) {
  RunningWorld world("<gravity>-1 0 -9.8</gravity>" + models());
  drive(world, 0.6);
  world.step(1400);
  EXPECT_LT(world.model("cart").pose().position.x(), -0.2);
  EXPECT_NEAR(world.model("cart").link("body")->linearVelocity().x(), 0.6, 1e-3);
  world.step(2500);
  EXPECT_NEAR(world.model("cart").link("body")->linearVelocity().x(), 0.6 - 0.6 * 1 * (8.0 / 4) / 19.6, 1e-3);
}

TEST(LookupWheelSlip, BeginsAnewAfterAReset) {
  const auto run = [](RunningWorld& world) {
    drive(world, 0.6);
    world.step(2500);
    return world.simulation().stateHash();
  };
  RunningWorld world(models());
  const std::uint64_t first = run(world);
  Diagnostics diagnostics;
  world.simulation().reset(diagnostics);
  EXPECT_EQ(run(world), first);
}

TEST(LookupWheelSlip, GoesOnWithTheSameBitsFromASavedState) {
  RunningWorld world(models());
  drive(world, 0.6);
  world.step(2500);
  RunningWorld other(models());
  test::expectSameBitsFromSavedState(world, other, 300);
}

TEST(LookupWheelSlip, SaysWhatItCanNotUse) {
  const auto complaint = [](const std::string& from, const std::string& to) {
    const std::vector<std::string> all = RunningWorld::complaintsAbout(replaced(models(), from, to));
    return all.empty() ? "" : all.front();
  };
  EXPECT_NE(complaint("slip_map.png", "none.png").find("none.png' is not found"), std::string::npos);
  EXPECT_NE(complaint("slip_map.png", "README.md").find("is not a PNG, JPEG, TGA or BMP image"), std::string::npos);
  EXPECT_NE(complaint("<wheel_link_name>front_left", "<wheel_link_name>body")
                .find("'body' is no wheel of WheelSlip in model 'cart'"),
            std::string::npos);
  EXPECT_NE(complaint("<size_x>8", "<size_x>0").find("size_x"), std::string::npos);
}

}  // namespace
}  // namespace pongsim::lookup_wheel_slip_test
