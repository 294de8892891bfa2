// The tutorial's robot against trajectories that Fortress's engine DART gave for the same wheel speeds.

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

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

struct Sample {
  Time time{0};
  Vector3 position;
};

// columns t, x, y, z, and a rotation that is left out
std::vector<Sample> readSamples(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  std::vector<Sample> samples;
  while (std::getline(stream, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream columns(line);
    double seconds = 0, x = 0, y = 0, z = 0;
    columns >> seconds >> x >> y >> z;
    samples.push_back({fromSeconds(seconds), {x, y, z}});
  }
  return samples;
}

class DriveTest : public testing::TestWithParam<Drive> {};

// Within 2 % of the distance travelled so far, or 5 mm while that is more.
TEST_P(DriveTest, StaysInTheCorridorOfFortress) {
  const auto worlds = test::fortressWorlds();
  const auto golden = test::goldenData();
  if (!worlds || !golden) GTEST_SKIP() << "Fortress's worlds or the recorded trajectories are not here";
  Diagnostics diagnostics;
  const sdf::Root root = sdf::loadFile(*worlds / "tutorials" / "moving_robot.sdf", diagnostics);
  ASSERT_FALSE(diagnostics.hasErrors());
  const std::vector<Sample> samples = readSamples(*golden / GetParam().file);
  ASSERT_EQ(samples.size(), 100U);

  const world::Entities entities(root.worlds.front());
  world::State state(entities);
  physics::Engine engine(entities);
  const world::Slot model = entities.findModel("vehicle_blue");
  const world::Slot chassis = entities.findLink(model, "chassis");
  const double turning = GetParam().angular * kHalfSeparation;
  engine.setJointVelocityTarget(entities.findJoint(model, "left_wheel_joint"),
                                (GetParam().linear - turning) / kWheelRadius);
  engine.setJointVelocityTarget(entities.findJoint(model, "right_wheel_joint"),
                                (GetParam().linear + turning) / kWheelRadius);

  double distance = 0;
  double largest = 0;
  Vector3 last = state.links[chassis].X_WorldLink.position;
  for (const Sample& sample : samples) {
    while (state.time < sample.time) {
      engine.step(kStep, state);
      state.time += kStep;
    }
    distance += (sample.position - last).norm();
    last = sample.position;
    const double deviation = (state.links[chassis].X_WorldLink.position - sample.position).norm();
    EXPECT_LT(deviation, std::max(0.02 * distance, 0.005))
        << "after " << toSeconds(sample.time) << " s and " << distance << " m";
    largest = std::max(largest, deviation);
  }
  RecordProperty("largest_deviation_mm", std::to_string(1000 * largest));
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
