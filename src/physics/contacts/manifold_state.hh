#pragma once

#include <BulletCollision/NarrowPhaseCollision/btManifoldPoint.h>

#include <vector>

#include "physics/contacts/dispatcher.hh"
#include "pongsim/state/state_archive.hh"

namespace pongsim::physics {

/// The contact points of two parts, with the impulses that warm-start the next step.
struct ManifoldPoints {
  /// Slots of the links, and numbers of their collisions.
  int linkA = 0;
  int partA = 0;
  int linkB = 0;
  int partB = 0;
  std::vector<btManifoldPoint> points;

  void transfer(StateArchive& archive);
};

/// @return All manifolds with contacts, sorted by slot.
std::vector<ManifoldPoints> listManifolds(Dispatcher& dispatcher);

/// Restores points to the manifolds of the same two parts, and empties all others. Points of two parts that are not
/// near each other now, and so have no manifold, are left out: the next step would have dropped them. So are points of
/// collisions that the links do not have. If there are several entries for two parts, the first one counts.
void restoreManifolds(const std::vector<ManifoldPoints>& list, Dispatcher& dispatcher);

/// Saves the points of all manifolds, or restores them as `restoreManifolds` does.
void transferManifolds(StateArchive& archive, Dispatcher& dispatcher);

}  // namespace pongsim::physics
