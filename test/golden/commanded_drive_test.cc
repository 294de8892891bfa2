// Compares the whole simulator, with DiffDrive commanded by topic, with the path of Fortress's engine.

#include <gtest/gtest.h>

#include "golden/corridor.hh"
#include "pongsim/simulation.hh"
#include "support/fortress_worlds.hh"

namespace pongsim {
namespace {

TEST(CommandedDrive, StaysInTheCorridorOfFortress) {
  const auto worlds = test::fortressWorlds();
  const auto golden = test::goldenData();
  if (!worlds || !golden) GTEST_SKIP() << "Fortress's worlds or the recorded trajectories are not here";
  Diagnostics diagnostics;
  const auto simulation = Simulation::fromFile(*worlds / "tutorials/moving_robot.sdf", {}, diagnostics);
  ASSERT_NE(simulation, nullptr);
  EXPECT_TRUE(diagnostics.all().empty());

  Publisher command = simulation->transport().node().advertise("/cmd_vel", "ignition.msgs.Twist");
  const MessagePointer twist = newMessage("ignition.msgs.Twist");
  ASSERT_FALSE(parseMessage("linear: {x: 0.5}, angular: {z: 0.05}", *twist).has_value());
  command.publish(*twist);

  const Link chassis = simulation->world().model("vehicle_blue")->link("chassis").value();
  const auto positionAt = [&](Time time) {
    while (simulation->time() < time) simulation->step();
    return chassis.pose().position;
  };
  test::expectWithinCorridor(test::readSamples(*golden / "drive_v0.5_w0.05.csv"), chassis.pose().position, positionAt);
}

}  // namespace
}  // namespace pongsim
