// Tests the decisions of examples/wall_avoider, in a world that waits for it in each step.

#include <gtest/gtest.h>
#include <ignition/msgs/laserscan.pb.h>
#include <ignition/msgs/twist.pb.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "../../examples/wall_avoider/command.hh"
#include "support/fortress_worlds.hh"
#include "support/running_world.hh"

namespace pongsim::test {
namespace {

TEST(WallAvoider, KeepsItsDistanceInFortressTutorial) {
  const auto worlds = fortressWorlds();
  if (!worlds) GTEST_SKIP() << "no worlds of Fortress here";
  RunningWorld world(*worlds / "tutorials/sensor_tutorial.sdf");
  Node node = world.simulation().transport().node();
  Publisher commands = node.advertise<ignition::msgs::Twist>("/cmd_vel");
  double nearest = std::numeric_limits<double>::infinity();
  const Subscription scans =
      node.subscribe<ignition::msgs::LaserScan>("/lidar", [&](const ignition::msgs::LaserScan& scan) {
        for (const double range : scan.ranges()) nearest = std::min(nearest, range);
        commands.publish(wall_avoider::commandFor(scan));
      });
  bool isTouched = false;
  const Subscription touches =
      node.subscribe("/wall/touched", "ignition.msgs.Boolean", [&](const Message&) { isTouched = true; });
  world.step(60'000);
  // it came close, and its braking distance is short
  EXPECT_LT(nearest, wall_avoider::kNear);
  EXPECT_GT(nearest, wall_avoider::kNear - 0.2);
  EXPECT_FALSE(isTouched);
  EXPECT_GT(std::abs(world.model("vehicle_blue").pose().position.y()), 2) << "it stands still";
}

}  // namespace
}  // namespace pongsim::test
