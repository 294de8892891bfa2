#pragma once

#include "physics/dispatcher.hh"
#include "pongsim/state_archive.hh"

namespace pongsim::physics {

/// Takes the points of all manifolds, with the impulses that the next step begins with; or gives them back to the
/// manifolds of the same two parts, and empties the others. Points of two parts that are not near each other now, and
/// have no manifold, are left out: the next step would have dropped them.
void transferManifolds(StateArchive& archive, Dispatcher& dispatcher);

}  // namespace pongsim::physics
