// Compares recordings of flying models, and of boxes pushed along waypoints. docs/physics.md lists the deviations and
// their reasons.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "golden/recording.hh"

namespace pongsim::test {
namespace {

TEST(AirRecording, QuadcopterClimbsWithFourMotors) {
  if (!Replay::isHere()) GTEST_SKIP() << "Fortress's worlds or recordings are not here";
  Replay replay("test/quadcopter.sdf", {{Time(0), "/X3/gazebo/command/motor_speed", "ignition.msgs.Actuators",
                                         "velocity:[700, 700, 700, 700]"}});
  replay.run();
  EXPECT_TRUE(replay.missing().empty());
  EXPECT_LT(replay.of("model X3").largest, 5e-3);
  EXPECT_LT(replay.of("model X3").largestAngle, 1e-5);
  // Fortress's motors are at rest in their first step, so its angle is smaller by a step at 700 rad/s
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(replay.of("joint X3::rotor_" + std::to_string(i) + "_joint").last, 0.7, 1e-3);
  }
}

TEST(AirRecording, QuadcopterFliesAsItIsTold) {
  if (!Replay::isHere()) GTEST_SKIP() << "Fortress's worlds or recordings are not here";
  Replay replay("test/quadcopter_velocity_control.sdf", {{Time(0), "/X3/gazebo/command/twist", "ignition.msgs.Twist",
                                                          "linear: {x: 0.3, z: 0.5}, angular: {z: 0.2}"}});
  replay.run();
  EXPECT_TRUE(replay.missing().empty());
  EXPECT_LT(replay.of("model X3").largest, 5e-3);
  EXPECT_LT(replay.of("model X3").largestAngle, 3e-3);
}

using Points = std::vector<Vector3>;

double distanceToPath(const Vector3& point, const Points& path) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Vector3 way = path[i + 1] - path[i];
    const double share =
        way.squaredNorm() > 0 ? std::clamp((point - path[i]).dot(way) / way.squaredNorm(), 0.0, 1.0) : 0;
    least = std::min(least, (point - path[i] - share * way).norm());
  }
  return least;
}

double farthest(const Points& points, const Points& path) {
  double most = 0;
  for (const Vector3& point : points) most = std::max(most, distanceToPath(point, path));
  return most;
}

// The time a sliding box takes to turn depends on friction, so after the first leg paths are compared without times.
TEST(AirRecording, BoxesFollowTheirTrajectories) {
  if (!Replay::isHere()) GTEST_SKIP() << "Fortress's worlds or recordings are not here";
  Replay replay("examples/trajectory_follower.sdf");
  std::map<std::string, std::pair<Points, Points>> paths;
  double firstWay = 0;
  replay.run([&](const RecordedRow& row) {
    if (row.what != "model") return;
    auto& [recorded, ours] = paths[row.name];
    recorded.emplace_back(row.values[0], row.values[1], row.values[2]);
    ours.push_back(replay.simulation().world().model(row.name)->pose().position);
    // the first box turns at 6.65 s
    if (row.time <= std::chrono::milliseconds(6600)) {
      firstWay = std::max(firstWay, (recorded.back() - ours.back()).norm());
    }
  });
  EXPECT_TRUE(replay.missing().empty());
  std::printf("first way: %.4g m\n", firstWay);
  EXPECT_LT(firstWay, 0.1);
  for (const auto& [name, both] : paths) {
    const auto& [recorded, ours] = both;
    std::printf("%s: %.4g m from the recorded path, which leads %.4g m from ours\n", name.c_str(),
                farthest(ours, recorded), farthest(recorded, ours));
    EXPECT_LT(farthest(ours, recorded), 0.1) << name;
    EXPECT_LT(farthest(recorded, ours), 0.15) << name;
  }
}

}  // namespace
}  // namespace pongsim::test
