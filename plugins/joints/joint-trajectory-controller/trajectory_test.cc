#include "trajectory.hh"

#include <gtest/gtest.h>

#include <chrono>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace pongsim::trajectory_test {
namespace {

using std::chrono::milliseconds;

/// Points 100 ms apart, the first at 100 ms, each with its number as position of both joints.
ignition::msgs::JointTrajectory messageOf(int points) {
  ignition::msgs::JointTrajectory message;
  message.add_joint_names("a");
  message.add_joint_names("b");
  for (int i = 0; i < points; ++i) {
    auto& point = *message.add_points();
    point.mutable_time_from_start()->set_nsec((i + 1) * 100'000'000);
    point.add_positions(i);
    point.add_positions(i);
  }
  return message;
}

TEST(Trajectory, GoesFromPointToPoint) {
  Trajectory trajectory(messageOf(3), milliseconds(1000));
  EXPECT_FALSE(trajectory.advance(milliseconds(999)));
  EXPECT_TRUE(trajectory.advance(milliseconds(1000)));
  EXPECT_FALSE(trajectory.advance(milliseconds(1100)));
  EXPECT_TRUE(trajectory.advance(milliseconds(1101)));
  EXPECT_NEAR(trajectory.progress(), 2.0 / 3, 1e-12);
  JointTarget target{.velocity = 7};
  trajectory.target(1, target);
  EXPECT_EQ(target.position, 1);
  EXPECT_EQ(target.velocity, 7) << "the point does not say it";
  EXPECT_TRUE(trajectory.advance(milliseconds(9000)));
  EXPECT_EQ(trajectory.progress(), 1);
  EXPECT_FALSE(trajectory.advance(milliseconds(9100)));
}

TEST(Trajectory, OfOnePointCounts) {
  Trajectory trajectory(messageOf(1), Time::zero());
  EXPECT_TRUE(trajectory.advance(Time::zero()));
  EXPECT_EQ(trajectory.progress(), 1);
}

TEST(Trajectory, RefusesAStateWithoutItsPoint) {
  Trajectory trajectory(messageOf(2), Time::zero());
  Trajectory other;
  for (Trajectory* each : {&trajectory, &other}) {
    StateArchive taking;
    each->transfer(taking);
    const std::vector<std::byte> bytes = taking.take();
    StateArchive giving(bytes);
    if (each == &trajectory) {
      EXPECT_NO_THROW(each->transfer(giving));
    } else {
      EXPECT_THROW(each->transfer(giving), std::out_of_range);
    }
  }
}

TEST(Trajectory, SaysWhatIsWrong) {
  EXPECT_EQ(Trajectory::fault(messageOf(3)), std::nullopt);
  EXPECT_EQ(Trajectory::fault({}), "it has no joint names");
  EXPECT_EQ(Trajectory::fault(messageOf(0)), "it has no points");
  auto message = messageOf(2);
  message.mutable_points(1)->add_positions(1);
  EXPECT_EQ(Trajectory::fault(message), "point 1 does not have a value for each of the 2 joints");
  message = messageOf(2);
  message.mutable_points(1)->mutable_time_from_start()->set_nsec(0);
  EXPECT_EQ(Trajectory::fault(message), "point 1 is not later than the previous one");
}

}  // namespace
}  // namespace pongsim::trajectory_test
