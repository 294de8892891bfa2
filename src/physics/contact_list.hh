#pragma once

#include <BulletCollision/BroadphaseCollision/btDispatcher.h>

#include <deque>
#include <vector>

#include "physics/body.hh"
#include "pongsim/contact.hh"
#include "world/entities.hh"

namespace pongsim::physics {

/// Replaces `contacts` by the points at which bodies touched in the last step, ordered by their collisions' ids, the
/// smaller one first.
/// @param bodies One a link, in the order of their slots.
/// @param dt Length of that step [s].
void listContacts(btDispatcher& dispatcher, const std::deque<Body>& bodies, const world::Entities& entities, double dt,
                  std::vector<Contact>& contacts);

}  // namespace pongsim::physics
