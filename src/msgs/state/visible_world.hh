#pragma once

#include "description/world.hh"
#include "pongsim/diagnostic.hh"
#include "pongsim/message.hh"

namespace pongsim::msgs {

/// Builds the part of a world's description that cameras need from its state: models, links, visuals and lights at
/// their current poses, actors with their scripts, and the rest of the scene.
/// @param step An `ignition.msgs.SerializedStepMap` with the complete state. Unreadable parts are left out.
/// @param diagnostics Gets a warning for each mesh, heightmap or texture file that is not on this machine; files are
/// searched under the path in the state, and where worlds find their files.
description::World visibleWorld(const Message& step, Diagnostics& diagnostics);

/// @param a, b As above.
/// @return Whether their visible worlds differ in the poses of models and links and in lights only.
bool haveSameLooks(const Message& a, const Message& b);

}  // namespace pongsim::msgs
