// Compares batteries, breadcrumbs and performers with the recordings of Fortress's server.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

#include "golden/recording.hh"

namespace pongsim::test {
namespace {

using std::chrono::milliseconds;

// The recorded server, 6.5.0, does not know <start_draining>, and reports 1 for a battery until it drains. So the first
// battery, which should drain from the start with less than its capacity, is constant there.
TEST(TasksRecording, BatteryKeepsItsChargeUntilItDrains) {
  if (!Replay::isHere()) GTEST_SKIP() << "Fortress's worlds or recordings are not here";
  Replay replay("test/battery.sdf", {},
                {{"linear_battery_demo_model", "linear_battery"},
                 {"linear_battery_demo_model_with_topics", "linear_battery_topics"}});
  replay.run();
  EXPECT_TRUE(replay.missing().empty());
  EXPECT_EQ(replay.of("battery linear_battery_topics").largest, 0);
  const double atStart = 1.1665 / 1.2009;
  EXPECT_GT(replay.of("battery linear_battery").last, 1 - atStart + 0.1);
}

TEST(TasksRecording, PerformerGoesOnItsWay) {
  if (!Replay::isHere()) GTEST_SKIP() << "Fortress's worlds or recordings are not here";
  Replay replay("test/performer_detector.sdf",
                {{Time(0), "/model/vehicle_blue/cmd_vel", "ignition.msgs.Twist", "linear: {x: 0.5}"}});
  replay.run();
  EXPECT_TRUE(replay.missing().empty());
  const Deviation& vehicle = replay.of("model vehicle_blue");
  EXPECT_GT(vehicle.way, 2.5);
  EXPECT_LT(vehicle.largest, std::max(0.02 * vehicle.way, 0.05));
}

TEST(TasksRecording, BreadcrumbsAreLeftWhereFortressLeavesThem) {
  if (!Replay::isHere()) GTEST_SKIP() << "Fortress's worlds or recordings are not here";
  Replay replay("test/breadcrumbs.sdf",
                {{milliseconds(500), "/model/vehicle_blue/breadcrumbs/B1/deploy", "ignition.msgs.Empty", ""},
                 {milliseconds(1000), "/rename_deploy", "ignition.msgs.Empty", ""}});
  replay.run();
  EXPECT_TRUE(replay.missing().empty());
  // it is inserted 10.7 cm inside the vehicle. We push it out at once, Fortress's engine by a millimetre per second
  EXPECT_LT(replay.of("model B1_0").largest, 0.05);
  EXPECT_LT(replay.of("model B1_0").largestAngle, 0.01);
  EXPECT_LT(replay.of("model B1_0_1").largest, 1e-3);
  EXPECT_LT(replay.of("model vehicle_blue").largest, 5e-3);
  std::vector<std::string> names;
  for (const Model& model : replay.simulation().world().models()) {
    if (model.name().starts_with("B1")) names.emplace_back(model.name());
  }
  EXPECT_EQ(names, (std::vector<std::string>{"B1_0", "B1_0_1"}));
}

}  // namespace
}  // namespace pongsim::test
