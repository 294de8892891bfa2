#pragma once

#include "description/actor.hh"

namespace ignition::msgs {
class Actor;
}

namespace pongsim::msgs {

/// Fills in an actor as Fortress does, without its links.
void setActor(const description::Actor& actor, ignition::msgs::Actor& message);

/// @return The actor in a message. Its files keep the message's names (`uri`) and are not looked for.
description::Actor actorFrom(const ignition::msgs::Actor& message);

}  // namespace pongsim::msgs
