#include "msgs/scene/actor_message.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/actor.pb.h>

namespace pongsim::msgs {
namespace {

TEST(ActorMessage, MakesTheSameActorAgain) {
  description::Actor actor;
  actor.name = "walker";
  actor.X_WorldActor.position = {1, 2, 3};
  actor.skin = {"walk.dae", {}, 2};
  actor.animations = {{"walk", {"steps.dae", {}, 0.5}, true}};
  actor.loops = false;
  actor.startDelay = 1.5;
  description::Trajectory& trajectory = actor.trajectories.emplace_back();
  trajectory.id = 4;
  trajectory.type = "walk";
  trajectory.tension = 0.5;
  trajectory.waypoints = {{0, {}}, {2.5, {{4, 5, 6}, fromRollPitchYaw(0, 0, 1)}}};
  ignition::msgs::Actor message;
  setActor(actor, message);
  EXPECT_EQ(message.entity().name(), "walker");
  EXPECT_EQ(message.trajectories(0).waypoints(1).time(), 2.5);
  EXPECT_EQ(actorFrom(message), actor);
}

TEST(ActorMessage, NamesFilesByTheirFullPath) {
  description::Actor actor;
  actor.skin = {"model://walker/walk.dae", "/models/walker/walk.dae", 1};
  ignition::msgs::Actor message;
  setActor(actor, message);
  EXPECT_EQ(message.skin_filename(), "/models/walker/walk.dae");
}

}  // namespace
}  // namespace pongsim::msgs
