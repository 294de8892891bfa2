#include <gtest/gtest.h>
#include <ignition/msgs/double.pb.h>

#include <string>
#include <utility>
#include <vector>

#include "support/going_on.hh"
#include "support/running_world.hh"

namespace pongsim::buoyancy_engine_test {
namespace {

using test::RunningWorld;

constexpr const char* kEngine =
    "<link_name>hull</link_name><min_volume>0.001</min_volume><neutral_volume>0.002</neutral_volume>"
    "<max_volume>0.003</max_volume><max_inflation_rate>0.01</max_inflation_rate>";
constexpr const char* kNeutral = "<default_volume>0.002</default_volume>";
constexpr const char* kTopic = "/buoyancy_engine";

/// A hull of 100 kg that nothing holds up but the engine's 1000 kg/m^3, in a gravity of 5 m/s^2 that it does not feel.
std::string worldWith(const std::string& parameters, const char* pose = "0 0 0 0 0 0") {
  return std::string("<gravity>0 0 -5</gravity><model name='m'><pose>") + pose +
         "</pose><link name='hull'><gravity>false</gravity><inertial><mass>100</mass></inertial></link>"
         "<plugin filename='ignition-gazebo-buoyancy-engine-system' name='ignition::gazebo::systems::BuoyancyEngine'>" +
         parameters + "</plugin></model>";
}

double speedOf(RunningWorld& world) { return world.model("m").link("hull")->linearVelocity().z(); }

/// @return What the next step gives.
double forceIn(RunningWorld& world) {
  const double before = speedOf(world);
  world.step(1);
  return (speedOf(world) - before) / 1e-3 * 100;
}

TEST(BuoyancyEngine, NeitherLiftsNorSinksWithItsNeutralVolume) {
  RunningWorld world(worldWith(std::string(kEngine) + kNeutral));
  EXPECT_NEAR(forceIn(world), 0, 1e-9);
}

TEST(BuoyancyEngine, BeginsWithItsLeastVolume) {
  RunningWorld world(worldWith(kEngine));
  EXPECT_NEAR(forceIn(world), 1000 * (0.001 - 0.002) * 5, 1e-9);
  world.step(500);
  EXPECT_NEAR(forceIn(world), 1000 * (0.001 - 0.002) * 5, 1e-9);
}

TEST(BuoyancyEngine, PumpsAtItsRateUpToTheVolumeThatItIsTold) {
  RunningWorld world(worldWith(std::string(kEngine) + kNeutral));
  world.tellNumber(kTopic, 0.0025);
  world.step(29);
  EXPECT_NEAR(forceIn(world), 1000 * 0.0003 * 5, 1e-6);
  world.step(100);
  EXPECT_NEAR(forceIn(world), 1000 * 0.0005 * 5, 1e-6);
  // more than it holds
  world.tellNumber(kTopic, 1);
  world.step(200);
  EXPECT_NEAR(forceIn(world), 1000 * 0.001 * 5, 1e-6);
  world.tellNumber(kTopic, 0.0);
  world.step(300);
  EXPECT_NEAR(forceIn(world), 1000 * -0.001 * 5, 1e-6);
}

TEST(BuoyancyEngine, HasNoFluidAboveTheSurface) {
  RunningWorld world(worldWith(std::string(kEngine) + kNeutral + "<surface>1</surface>", "0 0 2 0 0 0"));
  EXPECT_NEAR(forceIn(world), -1000 * 0.002 * 5, 1e-9);
  RunningWorld below(worldWith(
      std::string(kEngine) + kNeutral + "<fluid_density>900</fluid_density><surface>3</surface>", "0 0 2 0 0 0"));
  EXPECT_NEAR(forceIn(below), 0, 1e-9);
}

TEST(BuoyancyEngine, TellsItsVolume) {
  RunningWorld world(worldWith(std::string(kEngine) + kNeutral + "<namespace>glider</namespace>"));
  std::vector<ignition::msgs::Double> volumes;
  world.listen("/model/glider/buoyancy_engine/current_volume", volumes);
  world.tellNumber("/model/glider/buoyancy_engine", 0.003);
  world.step(10);
  ASSERT_EQ(volumes.size(), 10U);
  EXPECT_NEAR(volumes.front().data(), 0.00201, 1e-9);
  EXPECT_NEAR(volumes.back().data(), 0.0021, 1e-9);
}

TEST(BuoyancyEngine, RefusesAbsurdVolumesAndGoesOn) {
  RunningWorld world(worldWith(std::string(kEngine) + kNeutral));
  world.tellAbsurdities(kTopic, "ignition.msgs.Double", "data: #", "1e+06");
  EXPECT_NEAR(speedOf(world), 0, 1e-12);
  world.tellNumber(kTopic, 0.003);
  world.step(10);
  EXPECT_GT(speedOf(world), 0);
}

TEST(BuoyancyEngine, GoesOnWithTheSameBitsFromASavedStateAndAfterAReset) {
  const std::string text = worldWith(std::string(kEngine) + kNeutral);
  RunningWorld world(text);
  world.tellNumber(kTopic, 0.003);
  world.step(50);
  RunningWorld other(text);
  test::expectSameBitsFromSavedState(world, other, 100);

  test::resetWorld(other);
  EXPECT_NEAR(forceIn(other), 0, 1e-9);
}

TEST(BuoyancyEngineParameters, AreWarnedOfWhereTheyMakeNoSense) {
  const std::string left = "buoyancy-engine of m is left out: ", link = "<link_name>hull</link_name>";
  for (const auto& [parameters, message] : std::vector<std::pair<std::string, std::string>>{
           {"", left + "no <link_name> is given"},
           {"<link_name>hul</link_name>", left + "<link_name> 'hul' is not a link of model 'm'"},
           {link + "<min_volume>-1</min_volume>", left + "<min_volume> must be zero or more"},
           {link + "<fluid_density>0</fluid_density>", left + "<fluid_density> must be above zero"},
           {link + "<max_volume>1e-5</max_volume>", left + "<max_volume> is below <min_volume>"},
           {link + "<default_volume>1</default_volume>",
            "<default_volume> is not between <min_volume> and <max_volume>"}}) {
    EXPECT_EQ(RunningWorld::complaintsAbout(worldWith(parameters)), std::vector{message});
  }
}

}  // namespace
}  // namespace pongsim::buoyancy_engine_test
