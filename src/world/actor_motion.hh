#pragma once

#include "description/actor.hh"
#include "pongsim/types.hh"
#include "world/state.hh"

namespace pongsim::world {

/// Where an actor is: on its trajectories, one after the other, from the delay of its script on. As in Fortress the
/// delay comes once, not with each loop, `<auto_start>` does nothing, and who does not loop stays where it ends;
/// positions are on a Hermite spline with the tangents (1 - tension) (p[i+1] - p[i-1]) / 2, rotations are interpolated
/// by Shoemake's "squad" ("Animating rotation with quaternion curves", SIGGRAPH 1985), each closed where its last
/// point is its first.
/// @param time Simulated, since the start.
/// @return Pose of the actor in the world; that of the file for an actor without waypoints.
Pose actorPose(const description::Actor& actor, Time time);

/// @return Where it is now: there, unless a system has moved it.
Pose actorPose(const description::Actor& actor, const State& state);

}  // namespace pongsim::world
