#include <gtest/gtest.h>
#include <ignition/msgs/twist.pb.h>
#include <ignition/msgs/wheel_slip_parameters_cmd.pb.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "support/example_world.hh"
#include "support/going_on.hh"
#include "support/running_world.hh"

namespace pongsim::wheel_slip_test {
namespace {

using test::replaced;
using test::RunningWorld;

// of the example: 8 kg on four wheels
constexpr double kLoad = 19.6, kMass = 8;

std::string models() { return test::modelsOf("plugins/drives/wheel-slip/wheel_slip.sdf"); }

/// @param pull Of gravity, sideways [m/s^2].
std::string cart(double pullX, double pullY = 0) {
  return "<gravity>" + std::to_string(pullX) + " " + std::to_string(pullY) + " -9.8</gravity>" + models();
}

void drive(RunningWorld& world, double speed) {
  ignition::msgs::Twist twist;
  twist.mutable_linear()->set_x(speed);
  world.tell("/model/cart/cmd_vel", twist);
}

void setSlip(RunningWorld& world, const std::string& name, std::uint64_t id, double lateral, double longitudinal) {
  ignition::msgs::WheelSlipParametersCmd command;
  command.mutable_entity()->set_name(name);
  command.mutable_entity()->set_id(id);
  command.set_slip_compliance_lateral(lateral);
  command.set_slip_compliance_longitudinal(longitudinal);
  world.tell("/world/w/wheel_slip", command);
}

Link wheel(RunningWorld& world, const char* name = "front_left") { return world.model("cart").link(name).value(); }
std::pair<double, double> slipOf(RunningWorld& world, const char* name = "front_left") {
  return wheel(world, name).collisions()[0].slip();
}

// slip / speed of the rim = compliance * force / load
TEST(WheelSlip, SlipsByForceAndSpeedOfTheRim) {
  for (const auto& [pull, speed] : std::vector<std::array<double, 2>>{{-1, 0.6}, {-2, 0.6}, {-2, 1.2}, {-4, 0.6}}) {
    RunningWorld world(cart(pull));
    drive(world, speed);
    world.step(2500);
    const double slip = speed * 1 * (kMass * -pull / 4) / kLoad;
    EXPECT_NEAR(speed - world.model("cart").link("body")->linearVelocity().x(), slip, 0.01 * slip)
        << pull << " " << speed;
  }
}

TEST(WheelSlip, SlipsSidewaysByItsLateralCompliance) {
  RunningWorld world(cart(0, -2));
  drive(world, 0.6);
  world.step(2500);
  const double slip = 0.6 * 0.5 * (kMass * 2 / 4) / kLoad;
  EXPECT_NEAR(world.model("cart").link("body")->linearVelocity().y(), -slip, 0.02 * slip);
}

TEST(WheelSlip, HoldsWhileTheWheelsStand) {
  RunningWorld world(cart(-2));
  world.step(1000);
  EXPECT_LT(world.model("cart").pose().position.norm(), 5e-3);
}

TEST(WheelSlip, TakesNewCompliancesWhileItRuns) {
  RunningWorld world(cart(-2));
  drive(world, 0.6);
  world.step(1000);
  const double scale = 0.6 / kLoad;
  EXPECT_NEAR(slipOf(world).first, 0.5 * scale, 1e-3 * scale);
  EXPECT_NEAR(slipOf(world).second, scale, 1e-3 * scale);
  setSlip(world, "cart::front_left", 0, 2, 3);
  setSlip(world, "", wheel(world, "back_left").id().value, 4, 5);
  world.step(1);
  EXPECT_NEAR(slipOf(world).first, 2 * scale, 2e-3 * scale);
  EXPECT_NEAR(slipOf(world).second, 3 * scale, 3e-3 * scale);
  EXPECT_NEAR(slipOf(world, "back_left").second, 5 * scale, 5e-3 * scale);
  EXPECT_NEAR(slipOf(world, "front_right").second, scale, 1e-3 * scale);
  // all of a model's
  setSlip(world, "cart", 0, 0, 0);
  world.step(1000);
  for (const char* name : {"front_left", "front_right", "back_left", "back_right"}) {
    EXPECT_EQ(slipOf(world, name), std::pair(0.0, 0.0));
  }
  EXPECT_NEAR(world.model("cart").link("body")->linearVelocity().x(), 0.6, 0.003);
  // of others nothing
  setSlip(world, "car", 0, 1, 1);
  setSlip(world, "", world.model("ground_plane").id().value, 1, 1);
  world.step(1);
  EXPECT_EQ(slipOf(world), std::pair(0.0, 0.0));
}

TEST(WheelSlip, IgnoresCompliancesThatMakeNoSense) {
  RunningWorld world(cart(-2));
  drive(world, 0.6);
  world.step(1000);
  const auto slip = slipOf(world);
  for (const double bad : {-1.0, double{NAN}, std::numeric_limits<double>::infinity(), 1e308}) {
    setSlip(world, "cart", 0, bad, 1);
    setSlip(world, "cart", 0, 1, bad);
  }
  world.step(1);
  EXPECT_NEAR(slipOf(world).second, slip.second, 1e-3 * slip.second);
}

TEST(WheelSlip, IsAsGoodAsIceWhereTheFileAsksForMore) {
  RunningWorld world("<gravity>-2 0 -9.8</gravity>" +
                     replaced(models(), "<slip_compliance_lateral>0.5", "<slip_compliance_lateral>1e308"));
  drive(world, 0.6);
  world.step(400);
  EXPECT_EQ(slipOf(world).first, 1e6);
}

TEST(WheelSlip, BeginsAnewAfterAReset) {
  RunningWorld world(cart(-2));
  drive(world, 0.6);
  world.step(400);
  const std::uint64_t told = world.simulation().stateHash();
  Diagnostics diagnostics;
  world.simulation().reset(diagnostics);
  setSlip(world, "cart", 0, 3, 3);
  drive(world, 0.6);
  world.step(400);
  EXPECT_NE(world.simulation().stateHash(), told);
  world.simulation().reset(diagnostics);
  drive(world, 0.6);
  world.step(400);
  EXPECT_EQ(world.simulation().stateHash(), told);
}

TEST(WheelSlip, GoesOnWithTheSameBitsFromASavedState) {
  RunningWorld world(cart(-2));
  setSlip(world, "cart", 0, 0.3, 2);
  drive(world, 0.6);
  world.step(300);
  RunningWorld other(cart(-2));
  other.step(30);
  test::expectSameBitsFromSavedState(world, other, 300);
}

TEST(WheelSlipParameters, WarnOfAWheelAndGoOnWithTheOthers) {
  const std::string second =
      "<collision name='other'><geometry><sphere><radius>0.01</radius></sphere></geometry></collision>";
  for (const auto& [from, to, message] : std::vector<std::array<std::string, 3>>{
           {"link_name=\"front_left\"", "link_name=\"front_lift\"", "'front_lift' is not a link of model 'cart'"},
           {"<wheel link_name=\"front_left\"", "<wheel", "<wheel> has no link_name"},
           {"link_name=\"front_left\"", "link_name=\"body\"",
            "'body' is not the child of exactly one joint with an axis"},
           {"<collision name=\"collision\">\n          <geometry><sphere>",
            second + "<collision name=\"collision\">"
                     "<geometry><sphere>",
            "'front_left' has 2 collisions"},
           {"<wheel_radius>0.1</wheel_radius>\n          <wheel_n", "<wheel_n", "<wheel> has no <wheel_radius>"},
           {"<wheel_radius>0.1</wheel_radius>\n          <wheel_normal_force>19.6",
            "<wheel_radius>0.1</wheel_radius><wheel_normal_force>0", "<wheel_normal_force> must be above zero"},
           {"<slip_compliance_lateral>0.5", "<slip_compliance_lateral>-1", "<slip_compliance_lateral> must be"},
           {"<slip_compliance_lateral>0.5", "<slip_compliance_lateral>much", "not a number"}}) {
    const std::vector<std::string> complaints = RunningWorld::complaintsAbout(replaced(models(), from, to));
    ASSERT_EQ(complaints.size(), 1U) << to;
    EXPECT_NE(complaints[0].find("a <wheel> is left out: "), std::string::npos) << complaints[0];
    EXPECT_NE(complaints[0].find(message), std::string::npos) << complaints[0];
  }
}

TEST(WheelSlipParameters, NeedAWheel) {
  std::string text = models();
  const std::size_t begin = text.find("<wheel link_name"), end = text.rfind("</wheel>");
  text.erase(begin, end + 8 - begin);
  const std::vector<std::string> complaints = RunningWorld::complaintsAbout(text);
  ASSERT_EQ(complaints.size(), 1U);
  EXPECT_NE(complaints[0].find("<wheel>"), std::string::npos) << complaints[0];
}

}  // namespace
}  // namespace pongsim::wheel_slip_test
