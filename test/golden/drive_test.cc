// Compares the tutorial's robot with trajectories of Fortress's engine DART for the same wheel speeds.

#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "golden/corridor.hh"
#include "physics/engine.hh"
#include "sdf/loader.hh"
#include "support/fortress_worlds.hh"
#include "world/entities.hh"
#include "world/state.hh"

namespace pongsim {
namespace {

constexpr Time kStep = std::chrono::milliseconds(1);
constexpr double kWheelRadius = 0.4;
constexpr double kHalfSeparation = 0.6;

struct Drive {
  std::string file;
  /// Commanded [m/s], [rad/s].
  double linear;
  double angular;
};

void PrintTo(const Drive& drive, std::ostream* stream) { *stream << drive.file; }

class DriveTest : public testing::TestWithParam<Drive> {};

TEST_P(DriveTest, StaysInTheCorridorOfFortress) {
  const auto worlds = test::fortressWorlds();
  const auto golden = test::goldenData();
  if (!worlds || !golden) GTEST_SKIP() << "Fortress's worlds or the recorded trajectories are not here";
  Diagnostics diagnostics;
  const sdf::Root root = sdf::loadFile(*worlds / "tutorials" / "moving_robot.sdf", diagnostics);
  ASSERT_FALSE(diagnostics.hasErrors());

  const world::Entities entities(root.worlds.front());
  world::State state(entities);
  physics::Engine engine(entities);
  const world::Slot model = entities.findModel("vehicle_blue");
  const world::LinkState& chassis = state.links[entities.findLink(model, "chassis")];
  const double turning = GetParam().angular * kHalfSeparation;
  engine.setJointVelocityTarget(entities.findJoint(model, "left_wheel_joint"),
                                (GetParam().linear - turning) / kWheelRadius);
  engine.setJointVelocityTarget(entities.findJoint(model, "right_wheel_joint"),
                                (GetParam().linear + turning) / kWheelRadius);

  const auto positionAt = [&](Time time) {
    for (; state.time < time; state.time += kStep) engine.step(kStep, state);
    return chassis.X_WorldLink.position;
  };
  test::expectWithinCorridor(test::readSamples(*golden / GetParam().file), chassis.X_WorldLink.position, positionAt);
}

INSTANTIATE_TEST_SUITE_P(Robot, DriveTest,
                         testing::Values(Drive{"drive_v0.5_w0.05.csv", 0.5, 0.05}, Drive{"drive_v0.5_w0.csv", 0.5, 0},
                                         Drive{"drive_v0_w0.5.csv", 0, 0.5}),
                         [](const auto& instance) {
                           return instance.param.angular == 0  ? "Straight"
                                  : instance.param.linear == 0 ? "OnTheSpot"
                                                               : "InABend";
                         });

}  // namespace
}  // namespace pongsim
