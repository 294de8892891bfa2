#include <gtest/gtest.h>
#include <ignition/msgs/vector3d.pb.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "support/going_on.hh"
#include "support/running_world.hh"

namespace pongsim::hydrodynamics_test {
namespace {

using test::RunningWorld;

constexpr double kMass = 10;

/// A ball "hull" of 10 kg and 2 kg m^2 that weighs 20 N under water.
std::string worldWith(const std::string& parameters, const char* gravity = "0 0 -2") {
  return std::string("<gravity>") + gravity +
         "</gravity><model name='m'><link name='hull'><inertial><mass>10</mass>"
         "<inertia><ixx>2</ixx><iyy>2</iyy><izz>2</izz></inertia></inertial></link>"
         "<plugin filename='ignition-gazebo-hydrodynamics-system' name='ignition::gazebo::systems::Hydrodynamics'>" +
         parameters + "</plugin></model>";
}

std::string hull(const std::string& parameters) { return "<link_name>hull</link_name>" + parameters; }

Link hullOf(RunningWorld& world) { return world.model("m").link("hull").value(); }

ignition::msgs::Vector3d current(double x, double y, double z) {
  ignition::msgs::Vector3d message;
  message.set_x(x);
  message.set_y(y);
  message.set_z(z);
  return message;
}

// terminal speeds: weight = d v, and weight = d v^2
TEST(Hydrodynamics, LetsABodySinkAsFastAsItsDragAllows) {
  RunningWorld linear(worldWith(hull("<zW>-40</zW>")));
  linear.step(2000);
  EXPECT_NEAR(hullOf(linear).linearVelocity().z(), -0.5, 0.005);
  RunningWorld quadratic(worldWith(hull("<zWabsW>-80</zWabsW>")));
  quadratic.step(2000);
  EXPECT_NEAR(hullOf(quadratic).linearVelocity().z(), -0.5, 0.005);
}

TEST(Hydrodynamics, SlowsABodyAsLinearDragDoes) {
  RunningWorld world(worldWith(hull("<xU>-40</xU><kP>-4</kP>"), "0 0 0"));
  hullOf(world).setVelocity({1, 0, 0}, {1, 0, 0});
  world.step(500);
  EXPECT_NEAR(hullOf(world).linearVelocity().x(), std::exp(-2), 0.01 * std::exp(-2));
  EXPECT_NEAR(hullOf(world).angularVelocity().x(), std::exp(-1), 0.01 * std::exp(-1));
}

// a ball drags half of the water along that it displaces: a = F / (m + m_a)
TEST(Hydrodynamics, MakesABodyHeavierByItsAddedMass) {
  RunningWorld world(worldWith(hull("<zDotW>-5</zDotW>")));
  world.step(1000);
  EXPECT_NEAR(hullOf(world).linearVelocity().z(), -20.0 / (kMass + 5), 0.01 * 20.0 / 15);
  RunningWorld without(worldWith(hull("<zDotW>-5</zDotW><disable_added_mass>true</disable_added_mass>")));
  without.step(1000);
  EXPECT_NEAR(hullOf(without).linearVelocity().z(), -2, 1e-6);
}

TEST(Hydrodynamics, CountsInTheFrameOfTheLink) {
  std::string text = worldWith(hull("<xU>-40</xU>"), "0 0 0");
  text.replace(text.find("<link name='hull'>"), 18, "<link name='hull'><pose>0 0 0 0 0 1.5707963267948966</pose>");
  RunningWorld world(text);
  hullOf(world).setVelocity({1, 1, 0}, {0, 0, 0});
  world.step(1);
  EXPECT_NEAR(hullOf(world).linearVelocity().x(), 1, 1e-9);
  EXPECT_NEAR(hullOf(world).linearVelocity().y(), 1 - 4e-3, 1e-9);
}

TEST(Hydrodynamics, TurnsAddedMassUnlessItIsToldNotTo) {
  for (const bool isOff : {false, true}) {
    RunningWorld world(worldWith(hull(std::string("<xDotU>-1</xDotU><yDotV>-4</yDotV>") +
                                      (isOff ? "<disable_coriolis>1</disable_coriolis>" : "")),
                                 "0 0 0"));
    hullOf(world).setVelocity({1, 0.5, 0}, {0, 0, 0});
    world.step(1);
    // N = (X_udot - Y_vdot) u v in Fortress
    EXPECT_NEAR(hullOf(world).angularVelocity().z() / 1e-3 * 2, isOff ? 0 : (-1 + 4) * 0.5, 1e-6);
  }
}

TEST(Hydrodynamics, DriftsWithTheCurrentThatItIsTold) {
  RunningWorld world(worldWith(hull("<xU>-40</xU><yV>-40</yV><default_current>0 0.5 0</default_current>"), "0 0 0"));
  world.step(3000);
  EXPECT_NEAR((hullOf(world).linearVelocity() - Vector3(0, 0.5, 0)).norm(), 0, 1e-4);
  world.tell("/ocean_current", current(1, 0, 0));
  world.step(3000);
  EXPECT_NEAR((hullOf(world).linearVelocity() - Vector3(1, 0, 0)).norm(), 0, 1e-4);
}

TEST(Hydrodynamics, ListensInItsNamespace) {
  RunningWorld world(worldWith(hull("<namespace>boat</namespace><xU>-40</xU>"), "0 0 0"));
  world.tell("/ocean_current", current(5, 0, 0));
  world.tell("/model/boat/ocean_current", current(1, 0, 0));
  world.step(3000);
  EXPECT_NEAR(hullOf(world).linearVelocity().x(), 1, 1e-4);
}

TEST(Hydrodynamics, RefusesAbsurdCurrentsAndGoesOn) {
  RunningWorld world(worldWith(hull("<xUabsU>-40</xUabsU>"), "0 0 0"));
  world.tellAbsurdities("/ocean_current", "ignition.msgs.Vector3d", "x: #", "100");
  EXPECT_EQ(hullOf(world).linearVelocity().norm(), 0);
  world.tell("/ocean_current", current(1, 0, 0));
  world.step(10);
  EXPECT_GT(hullOf(world).linearVelocity().x(), 0);
}

TEST(Hydrodynamics, GoesOnWithTheSameBitsFromASavedStateAndAfterAReset) {
  const std::string text = worldWith(hull("<zDotW>-5</zDotW><zWabsW>-80</zWabsW><xU>-3</xU>"));
  RunningWorld world(text);
  world.tell("/ocean_current", current(0.3, 0, 0));
  world.step(100);
  RunningWorld other(text);
  test::expectSameBitsFromSavedState(world, other, 100);

  test::resetWorld(other);
  other.step(100);
  RunningWorld fresh(text);
  fresh.step(100);
  EXPECT_EQ(other.simulation().stateHash(), fresh.simulation().stateHash());
}

TEST(HydrodynamicsParameters, AreWarnedOfWhereTheyMakeNoSense) {
  const std::string left = "hydrodynamics of m is left out: ";
  for (const auto& [parameters, message] : std::vector<std::pair<std::string, std::string>>{
           {"", left + "no <link_name> is given"},
           {"<link_name>hul</link_name>", left + "<link_name> 'hul' is not a link of model 'm'"},
           {hull("<xU>slow</xU>"), left + "<xU> is 'slow', which is not a number"},
           {hull("<xU>nan</xU>"), left + "<xU> must be a finite number"},
           {hull("<default_current>1e3 0 0</default_current>"), left + "<default_current> is too fast"},
           {hull("<xY>1</xY>"), "hydrodynamics of m does not know <xY>"},
           {hull("<yVV>-1</yVV>"), "<yVV> does not depend on the direction; for drag, use <yVabsV>"},
           {hull("<zDotW>-12</zDotW>"), "<zDotW> is more than the mass of the model: its motion will be unstable"}}) {
    EXPECT_EQ(RunningWorld::complaintsAbout(worldWith(parameters)), std::vector{message});
  }
}

}  // namespace
}  // namespace pongsim::hydrodynamics_test
