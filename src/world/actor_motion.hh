#pragma once

#include "assets/figures/gait.hh"
#include "description/actor.hh"
#include "pongsim/types.hh"
#include "world/state.hh"

namespace pongsim::world {

/// Pose of an actor: along its trajectories, one after the other, after the delay of its script. As in Fortress, the
/// delay comes once and not in each loop, `<auto_start>` has no effect, and an actor that does not loop stays at its
/// end. Positions are on a Hermite spline with the tangents (1 - tension) (p[i+1] - p[i-1]) / 2. Rotations are
/// interpolated by Shoemake's "squad" ("Animating rotation with quaternion curves", SIGGRAPH 1985). Both are closed if
/// the last point is the first one.
/// @param time Simulated, since the start.
/// @return Pose of the actor in the world; that of the file for an actor without waypoints.
Pose actorPose(const description::Actor& actor, Time time);

/// @return Its current pose: as above, unless a system has moved it.
Pose actorPose(const description::Actor& actor, const State& state);

/// @return What its limbs do: the animation of its trajectory, from the beginning of that on, unless a system has set
/// another. As in Fortress, an actor without trajectories has the motion in the file of its skin.
assets::Gait actorGait(const description::Actor& actor, const State& state);

}  // namespace pongsim::world
