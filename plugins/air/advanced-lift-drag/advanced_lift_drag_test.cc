#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "support/fortress_worlds.hh"
#include "support/going_on.hh"
#include "support/running_world.hh"

namespace pongsim::advanced_lift_drag_test {
namespace {

using test::RunningWorld;

// span 6 m, and 60 Pa at 10 m/s
constexpr const char* kWing =
    "<link_name>body</link_name><area>6</area><AR>6</AR><eff>0.9</eff><mac>1.5</mac><air_density>1.2</air_density>";
constexpr double kPressure = 60 * 6;

std::string surface(const std::string& joint, const std::string& rest) {
  return "<control_surface><name>" + joint + "</name>" + rest + "</control_surface>";
}

/// Model "m" with "body", of 2 kg and 5 kg m^2, and a flap that the joint "hinge" turns; without gravity.
std::string worldWith(const std::string& parameters) {
  return "<gravity>0 0 0</gravity><model name='m'><link name='body'><inertial><mass>2</mass>"
         "<inertia><ixx>5</ixx><iyy>5</iyy><izz>5</izz></inertia></inertial></link>"
         "<link name='flap'><pose>0 5 0 0 0 0</pose><inertial><mass>1</mass></inertial></link>"
         "<joint name='hinge' type='revolute'><parent>world</parent><child>flap</child>"
         "<axis><xyz>0 1 0</xyz></axis></joint><plugin filename='gz-sim-advanced-lift-drag-system' "
         "name='gz::sim::systems::AdvancedLiftDrag'>" +
         parameters + "</plugin></model>";
}

/// @return What the first step gives the body that moves so.
std::pair<Vector3, Vector3> accelerations(RunningWorld& world, const Vector3& linear,
                                          const Vector3& angular = Vector3::Zero()) {
  Link link = world.model("m").link("body").value();
  link.setVelocity(linear, angular);
  world.step(1);
  return {(link.linearVelocity() - linear) / 1e-3, (link.angularVelocity() - angular) / 1e-3};
}

TEST(AdvancedLiftDrag, PushesAnAircraftThatFlies) {
  RunningWorld world(worldWith(std::string(kWing) + "<CL0>0.2</CL0><CD0>0.03</CD0>"));
  const auto [linear, angular] = accelerations(world, {10, 0, 0});
  // without an angle of stall, that is a right angle: the model after it has no part
  EXPECT_NEAR(linear.z(), kPressure * 0.2 / 2, 1e-3);
  EXPECT_NEAR(linear.x(), -kPressure * (0.03 + 0.04 / (M_PI * 6 * 0.9)) / 2, 1e-3);
  EXPECT_NEAR(angular.norm(), 0, 1e-9);
}

TEST(AdvancedLiftDrag, ActsAtItsReferencePointAndInItsDirections) {
  RunningWorld world(
      worldWith(std::string(kWing) + "<CL0>0.2</CL0><cp>0 1 0</cp><forward>0 2 0</forward><upward>0 0 3</upward>"));
  const auto [linear, angular] = accelerations(world, {0, 10, 0});
  EXPECT_NEAR(linear.z(), kPressure * 0.2 / 2, 1e-3);
  EXPECT_NEAR(angular.x(), kPressure * 0.2 / 5, 1e-3);
}

TEST(AdvancedLiftDrag, FeelsTheWind) {
  RunningWorld world("<wind><linear_velocity>-6 0 0</linear_velocity></wind>" +
                     worldWith(std::string(kWing) + "<CL0>0.2</CL0>"));
  EXPECT_NEAR(accelerations(world, {4, 0, 0}).first.z(), kPressure * 0.2 / 2, 1e-3);
}

TEST(AdvancedLiftDrag, IsDampedByItsRates) {
  RunningWorld world(worldWith(std::string(kWing) + "<Cellp>-0.5</Cellp><CYr>0.2</CYr>"));
  const auto [linear, angular] = accelerations(world, {10, 0, 0}, {1, 0, 0});
  EXPECT_NEAR(angular.x(), -kPressure * 6 * 0.5 * 6 / 20 / 5, 1e-3);
}

// coefficients are per degree of the joint, in its direction
TEST(AdvancedLiftDrag, ReadsTheJointsOfItsSurfaces) {
  RunningWorld world(worldWith(std::string(kWing) + "<num_ctrl_surfaces>2</num_ctrl_surfaces>" +
                               surface("hinge", "<index>0</index><direction>-1</direction><Cem_ctrl>-0.02</Cem_ctrl>") +
                               surface("hinge", "<direction>1</direction><Cell_ctrl>0.01</Cell_ctrl>")));
  ASSERT_TRUE(world.model("m").joint("hinge")->resetPosition(0.1));
  const auto [linear, angular] = accelerations(world, {10, 0, 0});
  const double degrees = 0.1 * 180 / M_PI;
  EXPECT_NEAR(angular.y(), -kPressure * 1.5 * 0.02 * degrees / 5, 1e-3);
  EXPECT_NEAR(angular.x(), kPressure * 6 * 0.01 * degrees / 5, 1e-3);
}

// the example's plane: it lifts off at the speed at which its lift is its weight
TEST(AdvancedLiftDrag, LetsAPlaneTakeOffAndBank) {
  RunningWorld world(test::projectFolder() / "plugins/air/advanced-lift-drag/advanced_lift_drag.sdf");
  const Model plane = world.model("plane");
  const Link body = plane.link("body").value();
  world.tellText("/plane/motor", "ignition.msgs.Actuators", "velocity: [1000]");
  world.tellNumber("/model/plane/elevator", -0.03);
  while (body.pose().position.z() < 0.175 && world.simulation().time() < std::chrono::seconds(10)) world.step(10);
  const double weight = 1.2 * 9.8;
  EXPECT_NEAR(body.linearVelocity().norm(), std::sqrt(weight / (0.5 * 1.2041 * 0.34 * 0.42)), 1);
  world.step(3000);
  EXPECT_GT(body.pose().position.z(), 3);
  EXPECT_LT(std::abs(rollPitchYawOf(body.pose().rotation).x()), 0.2);
  EXPECT_NEAR(plane.joint("elevator_joint")->position(), -0.03, 0.005);
  const double before = rollPitchYawOf(body.pose().rotation).x();
  world.tellNumber("/model/plane/aileron", 0.1);
  world.step(300);
  EXPECT_GT(rollPitchYawOf(body.pose().rotation).x(), before + 0.2);
}

TEST(AdvancedLiftDrag, GoesOnWithTheSameBitsFromASavedState) {
  const std::string text = worldWith(std::string(kWing) + "<CL0>0.2</CL0><Cellp>-0.5</Cellp><CLa>5</CLa>");
  RunningWorld world(text);
  world.model("m").link("body")->setVelocity({10, 1, -1}, {0.1, 0, 0});
  world.step(100);
  RunningWorld other(text);
  test::expectSameBitsFromSavedState(world, other, 100);
}

TEST(AdvancedLiftDragParameters, AreWarnedOfWhereTheyMakeNoSense) {
  const std::string left = "advanced-lift-drag of m is left out: ";
  const auto with = [](const std::string& parameters) { return kWing + parameters; };
  for (const auto& [parameters, message] : std::vector<std::pair<std::string, std::string>>{
           {"<AR>6</AR><eff>1</eff>", left + "no <link_name> is given"},
           {"<link_name>body</link_name><eff>1</eff>", left + "no <AR> is given"},
           {"<link_name>body</link_name><AR>0</AR><eff>1</eff>", left + "<AR> must be above zero"},
           {"<link_name>wings</link_name><AR>6</AR><eff>1</eff>",
            left + "<link_name> 'wings' is not a link of model 'm'"},
           {with("<forward>0 0 0</forward>"), left + "<forward> must have a direction"},
           {with("<upward>2 0 0</upward>"),
            left + "<upward> is parallel to <forward>; it must have a component across it"},
           {with("<CLa>nan</CLa>"), left + "<CLa> must be a finite number"},
           {with("<CLz>1</CLz>"), "advanced-lift-drag of m does not know <CLz>"},
           {with("<num_ctrl_surfaces>1</num_ctrl_surfaces>" + surface("knee", "")),
            left + "<name> 'knee' is not a joint of model 'm'"},
           {with(surface("hinge", "")),
            "<num_ctrl_surfaces> is 0, but there are 1 <control_surface>s: 0 have an effect"}}) {
    EXPECT_EQ(RunningWorld::complaintsAbout(worldWith(parameters)), std::vector{message});
  }
}

}  // namespace
}  // namespace pongsim::advanced_lift_drag_test
