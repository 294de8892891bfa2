#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "support/example_world.hh"
#include "support/going_on.hh"
#include "support/running_world.hh"

namespace pongsim::spacecraft_thruster_model_test {
namespace {

using test::RunningWorld;

/// A free link "nozzle" of 2 kg and 1 kg m^2, whose centre of mass is 0.5 m ahead, without gravity.
std::string worldWith(const std::string& parameters) {
  return "<gravity>0 0 0</gravity><model name='craft'><link name='nozzle'><inertial><pose>0.5 0 0 0 0 0</pose>"
         "<mass>2</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia></inertial></link>"
         "<plugin filename='gz-sim-spacecraft-thruster-model-system' "
         "name='gz::sim::systems::SpacecraftThrusterModel'>" +
         parameters + "</plugin></model>";
}

constexpr const char* kThruster =
    "<link_name>nozzle</link_name><actuator_number>1</actuator_number><max_thrust>3</max_thrust>"
    "<duty_cycle_frequency>10</duty_cycle_frequency>";

void command(RunningWorld& world, double duty, const std::string& topic = "/craft") {
  world.tellText(topic, "ignition.msgs.Actuators", "normalized: [1, " + std::to_string(duty) + "]");
}

Vector3 velocityOf(RunningWorld& world) { return world.model("craft").link("nozzle")->linearVelocity(); }

// 3 N on 2 kg for the part of the time; as in Gazebo, a cycle of 0.1 s is 101 steps, and 0.25 of it 26
TEST(SpacecraftThrusterModel, FiresForAPartOfEachCycle) {
  for (const auto& [duty, steps] :
       std::vector<std::pair<double, int>>{{0.25, 26}, {0.5, 51}, {1, 101}, {0, 0}, {-1, 0}}) {
    RunningWorld world(worldWith(kThruster));
    command(world, duty);
    world.step(1010);
    EXPECT_NEAR(velocityOf(world).z(), 3.0 / 2 * steps * 10 * 1e-3, 3.0 / 2 * 2e-3) << duty;
  }
}

TEST(SpacecraftThrusterModel, FiresFirstInEachCycle) {
  RunningWorld world(worldWith(kThruster));
  command(world, 0.3);
  world.step(30);
  const double after = velocityOf(world).z();
  EXPECT_NEAR(after, 3.0 / 2 * 0.03, 3.0 / 2 * 2e-3);
  world.step(60);
  EXPECT_NEAR(velocityOf(world).z(), after, 3.0 / 2 * 2e-3);
}

TEST(SpacecraftThrusterModel, PushesTheCentreOfMassAlongTheLinksZAxis) {
  std::string text = worldWith(kThruster);
  text = test::replaced(text, "<link name='nozzle'>", "<link name='nozzle'><pose>0 0 0 1.5707963267948966 0 0</pose>");
  RunningWorld world(text);
  command(world, 1);
  world.step(100);
  EXPECT_NEAR((velocityOf(world) - Vector3(0, -0.15, 0)).norm(), 0, 1e-6);
  EXPECT_NEAR(world.model("craft").link("nozzle")->angularVelocity().norm(), 0, 1e-9);
}

TEST(SpacecraftThrusterModel, ListensToTheTopicThatItIsTold) {
  for (const auto& [parameters, topic] : std::vector<std::pair<std::string, std::string>>{
           {"", "/craft"},
           {"<topic>dart</topic>", "/dart"},
           {"<topic>dart</topic><sub_topic>command/duty_cycle</sub_topic>", "/dart/command/duty_cycle"},
           {"<sub_topic>duty</sub_topic>", "/craft/duty"}}) {
    RunningWorld world(worldWith(kThruster + parameters));
    command(world, 1, topic);
    world.step(10);
    EXPECT_GT(velocityOf(world).z(), 0) << topic;
  }
}

TEST(SpacecraftThrusterModel, GoesOnAfterCommandsThatMakeNoSense) {
  RunningWorld world(worldWith(kThruster));
  world.tellAbsurdities("/craft", "ignition.msgs.Actuators", "normalized: [0, #]");
  EXPECT_EQ(velocityOf(world).norm(), 0);
  testing::internal::CaptureStderr();
  world.tellText("/craft", "ignition.msgs.Actuators", "normalized: [1]");
  world.step(100);
  EXPECT_NE(testing::internal::GetCapturedStderr().find("has no value for actuator 1 and was ignored"),
            std::string::npos);
  EXPECT_EQ(velocityOf(world).norm(), 0);
  command(world, 1);
  world.step(100);
  EXPECT_NEAR(velocityOf(world).z(), 0.15, 3e-3);
}

TEST(SpacecraftThrusterModel, GoesOnWithTheSameBitsFromASavedStateAndRestsAfterAReset) {
  RunningWorld world(worldWith(kThruster));
  command(world, 0.4);
  world.step(155);
  RunningWorld other(worldWith(kThruster));
  test::expectSameBitsFromSavedState(world, other, 300);
  test::resetWorld(other);
  other.step(100);
  EXPECT_EQ(velocityOf(other).norm(), 0);
}

TEST(SpacecraftThrusterModel, SaysWhatIsWrongWithAThruster) {
  const std::string left = "spacecraft-thruster-model of craft is left out: ";
  const std::string rest = "<actuator_number>0</actuator_number><max_thrust>3</max_thrust>";
  for (const auto& [parameters, message] : std::vector<std::pair<std::string, std::string>>{
           {rest, left + "no <link_name> is given"},
           {"<link_name>nozle</link_name>" + rest, left + "<link_name> 'nozle' is not a link of model 'craft'"},
           {"<link_name>nozzle</link_name><actuator_number>0</actuator_number>", left + "no <max_thrust> is given"},
           {"<link_name>nozzle</link_name><duty_cycle_frequency>0</duty_cycle_frequency>" + rest,
            left + "<duty_cycle_frequency> must be above zero"},
           {"<link_name>nozzle</link_name><max_thrust>3</max_thrust>",
            "a thruster without an <actuator_number> has the number 0"}}) {
    EXPECT_EQ(RunningWorld::complaintsAbout(worldWith(parameters)), std::vector{message});
  }
}

}  // namespace
}  // namespace pongsim::spacecraft_thruster_model_test
