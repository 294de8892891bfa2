#include <gtest/gtest.h>
#include <ignition/msgs/altimeter.pb.h>

#include <cmath>
#include <string>
#include <vector>

#include "support/fortress_worlds.hh"
#include "support/running_world.hh"

namespace pongsim::altimeter_test {
namespace {

using test::RunningWorld;

std::string worldWith(const std::string& sensor) {
  return R"(<gravity>0 0 0</gravity>
    <plugin filename="ignition-gazebo-altimeter-system" name="ignition::gazebo::systems::Altimeter"/>
    <model name="m"><pose>0 0 3 0 0 0</pose><link name="l"><inertial><mass>1</mass></inertial>
      <sensor name="s" type="altimeter"><pose>0 0 1 0 0 0</pose>)" +
         sensor + "</sensor></link></model>";
}

constexpr const char* kTopic = "/world/w/model/m/link/l/sensor/s/altimeter";

TEST(Altimeter, MeasuresFromItsHeightAtTheStart) {
  RunningWorld world(worldWith(""));
  std::vector<ignition::msgs::Altimeter> messages;
  world.listen(kTopic, messages);
  world.model("m").setVelocity({0, 0, 2}, Vector3::Zero());
  world.step(500);
  ASSERT_EQ(messages.size(), 500U);
  EXPECT_NEAR(messages.back().vertical_reference(), 4, 1e-9);
  EXPECT_NEAR(messages.back().vertical_position(), 1, 1e-6);
  EXPECT_NEAR(messages.back().vertical_velocity(), 2, 1e-6);
  EXPECT_EQ(messages.back().header().stamp().nsec(), 500'000'000);
  EXPECT_EQ(messages.back().header().data(0).value(0), "m::l::s");
}

TEST(Altimeter, AddsTheNoiseThatTheFileAsksFor) {
  RunningWorld world(
      worldWith("<altimeter><vertical_position><noise type='gaussian'><stddev>0.5</stddev></noise></vertical_position>"
                "<vertical_velocity><noise type='gaussian'><mean>0.25</mean></noise></vertical_velocity></altimeter>"));
  std::vector<ignition::msgs::Altimeter> messages;
  world.listen(kTopic, messages);
  world.step(3000);
  double squares = 0;
  for (const ignition::msgs::Altimeter& message : messages) {
    squares += std::pow(message.vertical_position(), 2);
    EXPECT_NEAR(message.vertical_velocity(), 0.25, 1e-9);
  }
  EXPECT_NEAR(std::sqrt(squares / 3000), 0.5, 0.03);
}

TEST(Altimeter, OfFortressTestWorldFalls) {
  const auto worlds = test::fortressWorlds();
  if (!worlds) GTEST_SKIP() << "no worlds of Fortress here";
  RunningWorld world(*worlds / "test/altimeter.sdf");
  std::vector<ignition::msgs::Altimeter> messages;
  world.listen("/world/altimeter_sensor/model/altimeter_model/link/link/sensor/altimeter_sensor/altimeter", messages);
  world.step(200);
  ASSERT_FALSE(messages.empty());
  EXPECT_LT(messages.back().vertical_velocity(), 0);
  EXPECT_LT(messages.back().vertical_position(), 0);
}

}  // namespace
}  // namespace pongsim::altimeter_test
