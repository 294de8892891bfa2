#include <gtest/gtest.h>
#include <ignition/msgs/double.pb.h>

#include <string>
#include <vector>

#include "support/fortress_worlds.hh"
#include "support/running_world.hh"

namespace pongsim::kinetic_energy_monitor_test {
namespace {

using test::RunningWorld;

std::string worldWith(const std::string& parameters) {
  return R"(<model name="floor"><static>true</static><link name="l"><collision name="c"><geometry><box>
        <size>9 9 1</size></box></geometry></collision></link></model>
    <model name="m"><pose>0 0 2.5 0 0 0</pose><link name="ball"><inertial><mass>3</mass></inertial>
      <collision name="c"><geometry><sphere><radius>1</radius></sphere></geometry></collision></link>
    <plugin filename="ignition-gazebo-kinetic-energy-monitor-system"
            name="ignition::gazebo::systems::KineticEnergyMonitor">)" +
         parameters + "</plugin></model>";
}

TEST(KineticEnergyMonitor, TellsOfABlow) {
  RunningWorld world(worldWith("<link_name>ball</link_name>"));
  std::vector<ignition::msgs::Double> losses;
  world.listen("/model/m/kinetic_energy", losses);
  world.step(300);
  EXPECT_TRUE(losses.empty()) << "it is still falling";
  world.step(700);
  ASSERT_EQ(losses.size(), 1U);
  // 3 kg fall by 1 m
  EXPECT_NEAR(losses[0].data(), 29.4, 3);
}

TEST(KineticEnergyMonitor, KeepsQuietBelowItsThreshold) {
  RunningWorld world(
      worldWith("<link_name>ball</link_name><kinetic_energy_threshold>100</kinetic_energy_threshold>"
                "<topic>blow</topic>"));
  std::vector<ignition::msgs::Double> losses;
  world.listen("/blow", losses);
  world.step(1000);
  EXPECT_TRUE(losses.empty());
}

TEST(KineticEnergyMonitor, IsLeftOutWithTheReason) {
  const std::string left = "kinetic-energy-monitor of m is left out: ";
  EXPECT_EQ(RunningWorld::complaintsAbout(worldWith("")), std::vector<std::string>{left + "no <link_name> is given"});
  EXPECT_EQ(RunningWorld::complaintsAbout(worldWith("<link_name>k</link_name>")),
            std::vector<std::string>{left + "<link_name> 'k' is not a link of model 'm'"});
}

TEST(KineticEnergyMonitor, OfFortressExampleTellsOfTheFall) {
  const auto worlds = test::fortressWorlds();
  if (!worlds) GTEST_SKIP() << "no worlds of Fortress here";
  RunningWorld world(*worlds / "examples/kinetic_energy_monitor.sdf");
  std::vector<ignition::msgs::Double> losses;
  world.listen("/model/sphere/kinetic_energy", losses);
  world.step(5000);
  ASSERT_FALSE(losses.empty());
  EXPECT_GT(losses[0].data(), 100);
}

}  // namespace
}  // namespace pongsim::kinetic_energy_monitor_test
