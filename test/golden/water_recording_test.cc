// Compares fluids and bodies in them with Fortress's recordings. docs/physics.md lists the deviations.

#include <gtest/gtest.h>

#include <chrono>
#include <string>

#include "golden/recording.hh"

namespace pongsim::test {
namespace {

RecordedCommand number(const char* topic, double value) {
  return {Time(0), topic, "ignition.msgs.Double", "data: " + std::to_string(value)};
}

class WaterRecording : public testing::Test {
 protected:
  void SetUp() override {
    if (!Replay::isHere()) GTEST_SKIP() << "Fortress's worlds or recordings are not here";
  }
};

/// Checks that all recorded entities of a world stay within these distances [m, rad].
void expectNear(const Replay& replay, double distance, double angle) {
  EXPECT_TRUE(replay.missing().empty());
  EXPECT_FALSE(replay.all().empty());
  for (const auto& [name, deviation] : replay.all()) {
    if (name.starts_with("joint ")) continue;
    EXPECT_LT(deviation.largest, distance) << name;
    EXPECT_LT(deviation.largestAngle, angle) << name;
  }
}

constexpr const char* kRotorTopic = "/model/lift_drag_demo_model/joint/rod_1_joint/cmd_force";
constexpr const char* kRotorJoint = "joint lift_drag_demo_model::rod_1_joint";

// At 350 rad/s a step of 1 ms turns the blades by 20 degrees.
TEST_F(WaterRecording, LiftDragTurnsItsBlades) {
  Replay replay("examples/lift_drag.sdf", {number(kRotorTopic, 0.7)});
  replay.run();
  EXPECT_TRUE(replay.missing().empty());
  EXPECT_LT(replay.of(kRotorJoint).largest, 0.01 * 1136.5);
}

TEST_F(WaterRecording, LiftDragTurnsItsBladesAsItShouldInSmallSteps) {
  Replay replay("examples/lift_drag.sdf", {number(kRotorTopic, 0.7)});
  ASSERT_TRUE(replay.simulation().setStepSize(std::chrono::microseconds(100)));
  replay.run();
  EXPECT_LT(replay.of(kRotorJoint).largest, 0.001 * 1136.5);
}

TEST_F(WaterRecording, BuoyancyLetsSubmarinesSwimSinkAndRise) {
  Replay replay("examples/buoyancy.sdf", {number("/model/submarine/joint/propeller_joint/cmd_force", 1.2)});
  replay.run();
  EXPECT_TRUE(replay.missing().empty());
  EXPECT_LT(replay.of("model submarine_sinking").largest, 0.01 * 40.84);
  EXPECT_LT(replay.of("model submarine_buoyant").largest, 0.01 * 122.5);
  EXPECT_LT(replay.of("model submarine").largest, 0.01);
  EXPECT_LT(replay.of("joint submarine::propeller_joint").largest, 0.01 * 5.48);
}

TEST_F(WaterRecording, BuoyancyEngineHoldsItsBoxes) {
  Replay replay("test/buoyancy_engine.sdf");
  replay.run();
  expectNear(replay, 1e-5, 1e-5);
}

TEST_F(WaterRecording, BuoyancyInLayersSwingsABox) {
  Replay replay("test/buoyancy_graded_restoring_moments.sdf");
  replay.run();
  expectNear(replay, 1e-5, 1e-3);
}

TEST_F(WaterRecording, BuoyancyActsAtTheCentreOfVolume) {
  Replay replay("test/center_of_volume.sdf");
  replay.run();
  expectNear(replay, 1e-4, 1e-4);
}

TEST_F(WaterRecording, HydrodynamicsLeavesWhatRests) {
  Replay replay("test/hydrodynamics.sdf");
  replay.run();
  expectNear(replay, 1e-5, 1e-5);
}

TEST_F(WaterRecording, LiftDragLeavesWhatRests) {
  Replay replay("test/lift_drag.sdf");
  replay.run();
  expectNear(replay, 1e-5, 1e-5);
}

TEST_F(WaterRecording, ThrusterPushesItsSubmarine) {
  Replay replay("test/thruster_vel_cmd.sdf", {number("/model/custom/joint/propeller_joint/cmd_pos", 100)});
  replay.run();
  EXPECT_TRUE(replay.missing().empty());
  EXPECT_LT(replay.of("model sub").largest, 0.02 * 12.5);
  EXPECT_LT(replay.of("joint sub::propeller_joint").largest, 0.01 * 367);
}

TEST_F(WaterRecording, LiftDragDrivesAPlane) {
  Replay replay("examples/plane_propeller_demo.sdf",
                {number("/model/propeller_plane/joint/rod_1_joint/cmd_force", 70)});
  replay.run();
  EXPECT_TRUE(replay.missing().empty());
  EXPECT_LT(replay.of("model propeller_plane").largest, 0.001 * 64.7);
  EXPECT_LT(replay.of("joint propeller_plane::rod_1_joint").largest, 0.001 * 917);
}

}  // namespace
}  // namespace pongsim::test
