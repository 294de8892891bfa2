#pragma once

#include <BulletCollision/BroadphaseCollision/btDispatcher.h>

#include <vector>

#include "pongsim/contact.hh"
#include "world/entities.hh"

namespace pongsim::physics {

/// Replaces `contacts` with the points at which bodies touched in the last step (were closer than 0.1 mm or pushed each
/// other), sorted by their collisions' ids, smaller id first.
/// @param dt Length of that step [s].
void listContacts(btDispatcher& dispatcher, const world::Entities& entities, double dt, std::vector<Contact>& contacts);

}  // namespace pongsim::physics
