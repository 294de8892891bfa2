#pragma once

#include "description/actor.hh"

namespace ignition::msgs {
class Actor;
}

namespace pongsim::msgs {

/// Fills in an actor as Fortress does, that is without its links.
void setActor(const description::Actor& actor, ignition::msgs::Actor& message);

/// @return The actor that a message tells of. Its files are named as the message does (`uri`) and not looked for.
description::Actor actorFrom(const ignition::msgs::Actor& message);

}  // namespace pongsim::msgs
