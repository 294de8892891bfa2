#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "support/going_on.hh"
#include "support/running_world.hh"

namespace pongsim::lighter_than_air_dynamics_test {
namespace {

using test::RunningWorld;

constexpr const char* kCoefficients =
    "<air_density>1.2</air_density><force_inviscid_coeff>0.8</force_inviscid_coeff><force_viscous_coeff>3"
    "</force_viscous_coeff><moment_inviscid_coeff>-2.5</moment_inviscid_coeff><moment_viscous_coeff>7"
    "</moment_viscous_coeff><eps_v>4</eps_v><axial_drag_coeff>1.5</axial_drag_coeff>";

/// A free "hull" of 50 kg and 200 kg m^2, turned to the north.
std::string worldWith(const std::string& parameters) {
  return "<gravity>0 0 0</gravity><model name='ship'><link name='hull'><pose>0 0 0 0 0 1.5707963267948966</pose>"
         "<inertial><mass>50</mass><inertia><ixx>200</ixx><iyy>200</iyy><izz>200</izz></inertia></inertial></link>"
         "<plugin filename='gz-sim-lighter_than_air_dynamics-system' name='gz::sim::systems::LighterThanAirDynamics'>" +
         parameters + "</plugin></model>";
}

std::string ship() { return worldWith(std::string("<link_name>hull</link_name>") + kCoefficients); }

Link hullOf(RunningWorld& world) { return world.model("ship").link("hull").value(); }

// v' = -q A / m: v = v0 / (1 + v0 rho A t / (2 m))
TEST(LighterThanAirDynamics, BrakesAnAirshipAlongItsAxis) {
  RunningWorld world(ship());
  hullOf(world).setVelocity({0, 10, 0}, {0, 0, 0});
  world.step(5000);
  EXPECT_NEAR(hullOf(world).linearVelocity().y(), 10 / (1 + 10 * 1.2 * 1.5 * 5 / 100), 0.01);
  EXPECT_NEAR(hullOf(world).linearVelocity().x(), 0, 1e-9);
}

// as in Gazebo's own test: a small disturbance of the heading grows, as an airship without fins is unstable
TEST(LighterThanAirDynamics, TurnsAnAirshipOutOfItsCourse) {
  RunningWorld world(ship());
  hullOf(world).setVelocity({-0.1, 10, 0}, {0, 0, 0});
  world.step(1);
  // it drifts to the left of its nose, and turns to the right
  const double first = hullOf(world).angularVelocity().z();
  EXPECT_NEAR(first / 1e-3 * 200, -0.5 * 1.2 * 100.01 * (7 * 1e-4 + 2.5 * std::sin(2 * std::atan(0.01))), 0.1);
  world.step(2000);
  EXPECT_GT(std::abs(hullOf(world).angularVelocity().z()), 100 * std::abs(first));
}

TEST(LighterThanAirDynamics, GoesOnWithTheSameBitsFromASavedState) {
  RunningWorld world(ship());
  hullOf(world).setVelocity({1, 10, -1}, {0.1, 0, 0.1});
  world.step(100);
  RunningWorld other(ship());
  test::expectSameBitsFromSavedState(world, other, 100);
}

TEST(LighterThanAirDynamics, SaysWhatIsMissing) {
  const std::string left = "lighter_than_air_dynamics of ship is left out: ";
  EXPECT_EQ(RunningWorld::complaintsAbout(worldWith(kCoefficients)), std::vector{left + "no <link_name> is given"});
  EXPECT_EQ(RunningWorld::complaintsAbout(worldWith(std::string("<link_name>keel</link_name>") + kCoefficients)),
            std::vector{left + "<link_name> 'keel' is not a link of model 'ship'"});
  std::string text = ship();
  text.replace(text.find("<eps_v>4</eps_v>"), 16, "");
  EXPECT_EQ(RunningWorld::complaintsAbout(text), std::vector{left + "no <eps_v> is given"});
  text = ship();
  text.replace(text.find("1.2</air"), 3, "0");
  EXPECT_EQ(RunningWorld::complaintsAbout(text), std::vector{left + "<air_density> must be above zero"});
}

}  // namespace
}  // namespace pongsim::lighter_than_air_dynamics_test
