#pragma once

#include "description/world.hh"
#include "pongsim/diagnostic.hh"
#include "pongsim/message.hh"

namespace pongsim::msgs {

/// Makes of a world's state what cameras need of its description: models, links, visuals and lights, each where it is
/// now, actors with their scripts, and what surrounds them.
/// @param step An `ignition.msgs.SerializedStepMap` with the whole state. What in it can't be read is left out.
/// @param diagnostics A warning for each file of a mesh, a heightmap or a texture that is not on this machine; it is
/// looked for under the path that the state names, and where worlds find their files.
description::World visibleWorld(const Message& step, Diagnostics& diagnostics);

}  // namespace pongsim::msgs
