#include "world/actor_motion.hh"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <numbers>

namespace pongsim::world {
namespace {

using description::Actor;
using description::Trajectory;

constexpr double kPi = std::numbers::pi;

Pose place(double x, double y, double yaw = 0) { return {{x, y, 0}, fromRollPitchYaw(0, 0, yaw)}; }

Pose poseAt(const Actor& actor, double seconds) {
  return actorPose(actor, std::chrono::nanoseconds(std::llround(seconds * 1e9)));
}

void expectPlace(const Pose& pose, double x, double y, double yaw = 0) {
  EXPECT_NEAR(pose.position.x(), x, 1e-9);
  EXPECT_NEAR(pose.position.y(), y, 1e-9);
  EXPECT_NEAR(pose.rotation.angularDistance(fromRollPitchYaw(0, 0, yaw)), 0, 1e-7);
}

/// @return Along x to 4 m in 2 s, and on to 6 m and round to the left in 1 s.
Actor walker() {
  Actor actor;
  Trajectory& trajectory = actor.trajectories.emplace_back();
  trajectory.tension = 1;
  trajectory.waypoints = {{0, place(0, 0)}, {2, place(4, 0)}, {3, place(6, 0, kPi / 2)}};
  return actor;
}

TEST(ActorMotion, PassesItsWaypointsInTime) {
  for (const double tension : {0.0, 0.3, 1.0}) {
    Actor actor = walker();
    actor.trajectories[0].tension = tension;
    expectPlace(poseAt(actor, 0), 0, 0);
    expectPlace(poseAt(actor, 2), 4, 0);
    expectPlace(poseAt(actor, 3), 6, 0, kPi / 2);
  }
}

TEST(ActorMotion, IsOnASplineBetweenThem) {
  // with all tension the tangents vanish: 3 t^2 - 2 t^3 of the way
  EXPECT_NEAR(poseAt(walker(), 1).position.x(), 2, 1e-9);
  EXPECT_NEAR(poseAt(walker(), 0.5).position.x(), 4 * (3.0 / 16 - 2.0 / 64), 1e-9);
  // without: p0 = 0, p1 = 4 with tangents 2 at the open end and 3 at the second point
  Actor loose = walker();
  loose.trajectories[0].tension = 0;
  const double t = 0.25;
  const double expected = 4 * (3 * t * t - 2 * t * t * t) + 2 * (t * t * t - 2 * t * t + t) + 3 * (t * t * t - t * t);
  EXPECT_NEAR(poseAt(loose, 0.5).position.x(), expected, 1e-9);
}

TEST(ActorMotion, GoesSmoothlyThroughTheEndOfAClosedWay) {
  Actor actor;
  Trajectory& trajectory = actor.trajectories.emplace_back();
  trajectory.waypoints = {{0, place(1, 0)}, {1, place(0, 1)}, {2, place(-1, 0)}, {3, place(0, -1)}, {4, place(1, 0)}};
  const Vector3 before = poseAt(actor, 4).position - poseAt(actor, 3.999).position;
  const Vector3 behind = poseAt(actor, 4.001).position - poseAt(actor, 4).position;
  EXPECT_NEAR((before - behind).norm(), 0, 1e-5);
  EXPECT_GT(before.norm(), 5e-4);
}

TEST(ActorMotion, TurnsTheShorterWayAndEvenly) {
  Actor actor;
  actor.trajectories.emplace_back().waypoints = {
      {0, place(0, 0, 0.75 * kPi)}, {1, place(0, 0, kPi)}, {2, place(0, 0, -0.75 * kPi)}, {3, place(0, 0, -0.5 * kPi)}};
  expectPlace(poseAt(actor, 1.5), 0, 0, -0.875 * kPi);
  expectPlace(poseAt(actor, 1.25), 0, 0, -0.9375 * kPi);
}

TEST(ActorMotion, BeginsAfterItsDelayOnce) {
  Actor actor = walker();
  actor.startDelay = 5;
  expectPlace(poseAt(actor, 4), 0, 0);
  expectPlace(poseAt(actor, 7), 4, 0);
  // three seconds on it is there again
  expectPlace(poseAt(actor, 10), 4, 0);
}

TEST(ActorMotion, StaysAtItsEndUnlessItLoops) {
  Actor actor = walker();
  actor.loops = false;
  expectPlace(poseAt(actor, 100), 6, 0, kPi / 2);
}

TEST(ActorMotion, GoesAlongOneTrajectoryAfterTheOther) {
  Actor actor = walker();
  actor.trajectories.emplace_back();
  Trajectory& back = actor.trajectories.emplace_back();
  back.tension = 1;
  back.waypoints = {{0.5, place(6, 0)}, {1, place(0, 0)}};
  expectPlace(poseAt(actor, 2), 4, 0);
  expectPlace(poseAt(actor, 3.2), 6, 0);
  expectPlace(poseAt(actor, 3.75), 3, 0);
  expectPlace(poseAt(actor, 6), 4, 0);
}

TEST(ActorMotion, TellsWhatTheLimbsDo) {
  description::World description;
  Actor& actor = description.actors.emplace_back(walker());
  actor.trajectories[0].type = "walk";
  Entities entities(description);
  State state(entities);
  state.time = std::chrono::milliseconds(2500);
  const assets::Gait onTheWay = actorGait(actor, state);
  EXPECT_EQ(onTheWay.animation, "walk");
  EXPECT_EQ(onTheWay.time, 2.5);
  EXPECT_NEAR(onTheWay.distance, 5, 1e-12);
  EXPECT_TRUE(onTheWay.isOnPath && onTheWay.loops);
  // three seconds on it begins again
  state.time = std::chrono::milliseconds(4000);
  EXPECT_EQ(actorGait(actor, state).time, 1);
  state.actors.push_back({&actor, {}, "run", std::chrono::seconds(7)});
  EXPECT_EQ(actorGait(actor, state), (assets::Gait{.animation = "run", .time = 7}));
  state.actors.clear();
  actor.trajectories.clear();
  EXPECT_EQ(actorGait(actor, state), (assets::Gait{.animation = "", .time = 4, .isOnPath = false}));
}

TEST(ActorMotion, HasWaypointsInTheFrameOfTheActor) {
  Actor actor = walker();
  actor.X_WorldActor = place(10, 20, kPi / 2);
  expectPlace(poseAt(actor, 2), 10, 24, kPi / 2);
  actor.trajectories.clear();
  expectPlace(poseAt(actor, 2), 10, 20, kPi / 2);
}

}  // namespace
}  // namespace pongsim::world
