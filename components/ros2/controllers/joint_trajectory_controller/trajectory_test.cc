#include "ros2/controllers/joint_trajectory_controller/trajectory.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "ros2/controllers/joint_trajectory_controller/tolerances.hh"
#include "ros2/controllers/joint_trajectory_controller/trajectory_message.hh"

namespace pongsim::ros2 {
namespace {

TrajectoryPoint at(double seconds, std::vector<double> positions, std::vector<double> velocities = {},
                   std::vector<double> accelerations = {}) {
  return {fromSeconds(seconds), std::move(positions), std::move(velocities), std::move(accelerations)};
}

/// Begins at 1 s.
Trajectory begun(std::vector<TrajectoryPoint> points, TrajectoryPoint before) {
  Trajectory trajectory(Time::zero(), std::move(points));
  trajectory.begin(fromSeconds(1), std::move(before));
  return trajectory;
}

double position(const Trajectory& trajectory, double seconds) {
  return trajectory.sample(fromSeconds(seconds), true).state.positions[0];
}
double velocity(const Trajectory& trajectory, double seconds) {
  return trajectory.sample(fromSeconds(seconds), true).state.velocities[0];
}

TEST(Trajectory, IsLinearBetweenPositions) {
  const Trajectory trajectory = begun({at(1, {2}), at(3, {-2})}, at(0, {0}));
  EXPECT_NEAR(position(trajectory, 1.25), 0.5, 1e-12);
  EXPECT_NEAR(velocity(trajectory, 1.25), 2, 1e-12);
  EXPECT_NEAR(position(trajectory, 2), 2, 1e-12);
  EXPECT_NEAR(position(trajectory, 3), 0, 1e-12);
  EXPECT_NEAR(velocity(trajectory, 3), -2, 1e-12);
  const auto end = trajectory.sample(fromSeconds(4), true);
  EXPECT_TRUE(end.isOver);
  EXPECT_EQ(end.state.positions[0], -2);
  EXPECT_EQ(end.state.velocities[0], 0);
}

// 3 s^2 - 2 s^3 from rest to rest
TEST(Trajectory, IsCubicWithVelocities) {
  const Trajectory trajectory = begun({at(2, {4}, {0})}, at(0, {0}, {0}));
  for (const double s : {0.1, 0.5, 0.8}) {
    EXPECT_NEAR(position(trajectory, 1 + 2 * s), 4 * (3 * s * s - 2 * s * s * s), 1e-12);
    EXPECT_NEAR(velocity(trajectory, 1 + 2 * s), 2 * (6 * s - 6 * s * s), 1e-12);
  }
}

// 10 s^3 - 15 s^4 + 6 s^5 from rest to rest
TEST(Trajectory, IsQuinticWithAccelerations) {
  const Trajectory trajectory = begun({at(2, {4}, {0}, {0})}, at(0, {0}, {0}));
  for (const double s : {0.1, 0.5, 0.8}) {
    EXPECT_NEAR(position(trajectory, 1 + 2 * s), 4 * s * s * s * (10 - 15 * s + 6 * s * s), 1e-12);
    EXPECT_NEAR(velocity(trajectory, 1 + 2 * s), 2 * s * s * (30 - 60 * s + 30 * s * s), 1e-12);
  }
}

// the values at both ends are the given ones
TEST(Trajectory, HasTheGivenDerivativesAtItsPoints) {
  const Trajectory trajectory = begun({at(2, {1}, {0.5}, {-0.3}), at(3, {2}, {0}, {0})}, at(0, {-1}, {0.2}, {0.7}));
  const auto start = trajectory.sample(fromSeconds(1), true).state;
  EXPECT_NEAR(start.positions[0], -1, 1e-12);
  EXPECT_NEAR(start.velocities[0], 0.2, 1e-12);
  EXPECT_NEAR(start.accelerations[0], 0.7, 1e-12);
  const auto middle = trajectory.sample(fromSeconds(3) - Time(1), true).state;
  EXPECT_NEAR(middle.positions[0], 1, 1e-7);
  EXPECT_NEAR(middle.velocities[0], 0.5, 1e-7);
  EXPECT_NEAR(middle.accelerations[0], -0.3, 1e-6);
}

TEST(Trajectory, DeducesPositionsFromVelocities) {
  const Trajectory trajectory = begun({at(1, {}, {2}), at(2, {}, {0})}, at(0, {5}, {0}));
  EXPECT_NEAR(position(trajectory, 2), 6, 1e-12);
  EXPECT_NEAR(position(trajectory, 3), 7, 1e-12);
}

TEST(Trajectory, GoesToTheNextPointAtOnceWithoutInterpolation) {
  const Trajectory trajectory = begun({at(1, {2}), at(2, {3})}, at(0, {0}));
  EXPECT_EQ(trajectory.sample(fromSeconds(1.5), false).state.positions[0], 0);
  EXPECT_EQ(trajectory.sample(fromSeconds(2.5), false).state.positions[0], 3);
}

class TrajectoryMessageTest : public testing::Test {
 protected:
  std::string refusal() const { return readTrajectory(message_, rules_, {7, 8}, fromSeconds(10)).error; }

  TrajectoryRules rules_{.joints = {"a", "b"}};
  trajectory_msgs::JointTrajectory message_{{}, {"b", "a"}, {{{1, 2}, {}, {}, {}, {1, 0}}}};
};

TEST_F(TrajectoryMessageTest, PutsJointsInOrder) {
  const auto read = readTrajectory(message_, rules_, {7, 8}, fromSeconds(10));
  ASSERT_TRUE(read) << read.error;
  EXPECT_EQ(read.value->points()[0].positions, (std::vector<double>{2, 1}));
}

TEST_F(TrajectoryMessageTest, HoldsJointsThatAreLeftOutWhereThatIsAllowed) {
  message_.joint_names = {"b"};
  message_.points[0].positions = {3};
  EXPECT_NE(refusal().find("it has 1 of the 2 joints"), std::string::npos);
  rules_.allowsPartial = true;
  const auto read = readTrajectory(message_, rules_, {7, 8}, fromSeconds(10));
  ASSERT_TRUE(read) << read.error;
  EXPECT_EQ(read.value->points()[0].positions, (std::vector<double>{7, 3}));
}

TEST_F(TrajectoryMessageTest, RefusesWhatCannotBeFollowed) {
  const auto good = message_;
  const auto refusalOf = [&](const std::function<void()>& change) {
    message_ = good;
    change();
    return refusal();
  };
  EXPECT_EQ(refusalOf([&] { message_.points.clear(); }), "it has no points");
  EXPECT_EQ(refusalOf([&] { message_.joint_names[0] = "c"; }), "joint 'c' is none of its joints");
  EXPECT_EQ(refusalOf([&] { message_.joint_names[0] = "a"; }), "joint 'a' is there twice");
  EXPECT_EQ(refusalOf([&] { message_.points[0].positions = {1}; }), "point 0 has 1 values for 2 joints");
  EXPECT_EQ(refusalOf([&] {
              message_.points[0].positions = {1, INFINITY};
            }),
            "point 0 has a value that is not finite, or very large");
  EXPECT_EQ(refusalOf([&] { message_.points[0].positions.clear(); }), "point 0 has no positions");
  EXPECT_EQ(refusalOf([&] {
              message_.points[0].effort = {1, 1};
            }),
            "point 0 has efforts, without a command interface for them");
  EXPECT_EQ(refusalOf([&] { message_.points.push_back(message_.points[0]); }),
            "the time of point 1 is not after that of the one before");
  EXPECT_TRUE(refusalOf([&] { message_.points[0].velocities = {0, 1}; }).starts_with("it does not end at rest"));
  EXPECT_EQ(refusalOf([&] { message_.header.stamp = {5, 0}; }), "it ends in the past");
  EXPECT_EQ(refusalOf([] {}), "");
}

TEST(TrajectoryTolerances, AreReplacedByThoseOfAGoal) {
  TrajectoryTolerances tolerances{{{0.1, 0, 0}, {0.2, 0, 0}}, {{0.3, 0, 0}, {0.4, 0, 0}}, 1};
  control_msgs::action::FollowJointTrajectory::Goal goal;
  goal.path_tolerance = {{"b", 0.5, 0, -1}};
  goal.goal_tolerance = {{"a", -1, 0, 0}};
  goal.goal_time_tolerance = {2, 500'000'000};
  const auto replaced = tolerances.withThoseOf(goal, {"a", "b"});
  ASSERT_TRUE(replaced) << replaced.error;
  EXPECT_EQ(replaced.value->path[0].position, 0.1);
  EXPECT_EQ(replaced.value->path[1].position, 0.5);
  EXPECT_EQ(replaced.value->goal[0].position, 0);
  EXPECT_EQ(replaced.value->goalTime, 2.5);
  goal.path_tolerance = {{"c", 0.5, 0, 0}};
  EXPECT_EQ(tolerances.withThoseOf(goal, {"a", "b"}).error,
            "it has a tolerance of joint 'c', which is not one of its joints");
  const StateTolerance tolerance{0.1, 0, 0};
  EXPECT_TRUE(tolerance.contains({Time{}, {0.1}, {9}}, 0));
  EXPECT_FALSE(tolerance.contains({Time{}, {-0.11}}, 0));
}

}  // namespace
}  // namespace pongsim::ros2
