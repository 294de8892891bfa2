#pragma once

#include <BulletCollision/NarrowPhaseCollision/btManifoldPoint.h>

#include <vector>

#include "physics/contacts/dispatcher.hh"
#include "pongsim/state/state_archive.hh"

namespace pongsim::physics {

/// The points at which two parts touch, with the impulses that the next step begins with.
struct ManifoldPoints {
  /// Slots of the links, and numbers of their collisions.
  int linkA = 0;
  int partA = 0;
  int linkB = 0;
  int partB = 0;
  std::vector<btManifoldPoint> points;

  void transfer(StateArchive& archive);
};

/// @return All that touch, in the order of their slots.
std::vector<ManifoldPoints> listManifolds(Dispatcher& dispatcher);

/// Gives points back to the manifolds of the same two parts, and empties the others. Points of two parts that are not
/// near each other now, and have no manifold, are left out: the next step would have dropped them. Of several entries
/// for two parts the first one counts.
void restoreManifolds(const std::vector<ManifoldPoints>& list, Dispatcher& dispatcher);

/// Takes the points of all manifolds, or gives them back as `restoreManifolds` does.
void transferManifolds(StateArchive& archive, Dispatcher& dispatcher);

}  // namespace pongsim::physics
