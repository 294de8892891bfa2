#include "msgs/scene/actor_message.hh"

#include <ignition/msgs/actor.pb.h>

#include "msgs/scene/full_path.hh"
#include "msgs/scene/pose_message.hh"
#include "pongsim/messages/fields.hh"

namespace pongsim::msgs {

namespace im = ignition::msgs;

void setActor(const description::Actor& actor, im::Actor& message) {
  message.Clear();
  message.mutable_entity()->set_name(actor.name);
  setPose(actor.X_WorldActor, *message.mutable_pose());
  message.set_skin_filename(pathOf(actor.skin));
  message.set_skin_scale(static_cast<float>(actor.skin.scale));
  for (const description::Animation& animation : actor.animations) {
    im::Actor::Animation& added = *message.add_animations();
    added.set_name(animation.name);
    added.set_filename(pathOf(animation.source));
    added.set_scale(static_cast<float>(animation.source.scale));
    added.set_interpolate_x(animation.followsPath);
  }
  message.set_script_loop(actor.loops);
  message.set_script_delay_start(static_cast<float>(actor.startDelay));
  message.set_script_auto_start(actor.startsByItself);
  for (const description::Trajectory& trajectory : actor.trajectories) {
    im::Actor::Trajectory& added = *message.add_trajectories();
    added.set_id(static_cast<std::uint32_t>(trajectory.id));
    added.set_type(trajectory.type);
    added.set_tension(static_cast<float>(trajectory.tension));
    for (const description::Waypoint& waypoint : trajectory.waypoints) {
      im::Actor::Waypoint& point = *added.add_waypoints();
      point.set_time(static_cast<float>(waypoint.time));
      setPose(waypoint.X_ActorWaypoint, *point.mutable_pose());
    }
  }
}

description::Actor actorFrom(const im::Actor& message) {
  description::Actor actor;
  actor.name = message.entity().name();
  actor.X_WorldActor = poseFrom(message.pose());
  actor.skin = {message.skin_filename(), {}, message.skin_scale()};
  for (const im::Actor::Animation& animation : message.animations()) {
    actor.animations.push_back(
        {animation.name(), {animation.filename(), {}, animation.scale()}, animation.interpolate_x()});
  }
  actor.loops = message.script_loop();
  actor.startDelay = message.script_delay_start();
  actor.startsByItself = message.script_auto_start();
  for (const im::Actor::Trajectory& trajectory : message.trajectories()) {
    description::Trajectory& added = actor.trajectories.emplace_back();
    added.id = trajectory.id();
    added.type = trajectory.type();
    added.tension = trajectory.tension();
    for (const im::Actor::Waypoint& point : trajectory.waypoints()) {
      added.waypoints.push_back({point.time(), poseFrom(point.pose())});
    }
  }
  return actor;
}

}  // namespace pongsim::msgs
