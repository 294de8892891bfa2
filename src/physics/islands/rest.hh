#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <atomic>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "base/prefetch.hh"

class btPersistentManifold;

namespace pongsim::physics {

/// Knows which islands a step would leave as they are, to the bit: their state and inputs are those of the step before,
/// and that step changed nothing. Such a step need not be made; the result is the same. Islands with joints are always
/// solved.
///
/// Bodies are known by their island tags, which are their numbers, or -1 if forces do not move them. Threads may use
/// this at the same time for different islands, `disturb` for any.
class Rest {
 public:
  /// Sets the number of bodies that forces move. The first `kept` are the same as before; if any has been removed,
  /// nothing is known any more.
  void resize(std::size_t kept, std::size_t bodies);
  /// Forgets all that is known.
  void forget() { resize(0, count_); }

  /// Prefetches what is known about a body.
  /// @param tag Its island tag.
  void prefetch(int tag) const {
    if (tag >= 0) base::prefetch(records_[static_cast<std::size_t>(tag)]);
  }
  /// @return Whether the object is where it was when the last step looked for contacts.
  bool isStill(const btCollisionObject& object) const;
  /// To be called if the object's contacts are not those of the step before.
  void disturb(const btCollisionObject& object);

  /// Poses and contact impulses of islands before a step, one island after the other; memory for one thread.
  struct alignas(64) Snapshot {
    /// Where those of an island begin.
    struct Start {
      std::size_t poses;
      std::size_t impulses;
    };
    std::vector<btTransform> poses;
    std::vector<double> impulses;

    Start end() const { return {poses.size(), impulses.size()}; }
    void clear() {
      poses.clear();
      impulses.clear();
    }
  };
  /// @return Whether the coming step would leave the island as it is.
  bool isSettled(std::span<btRigidBody* const> bodies, std::span<btPersistentManifold* const> manifolds) const;
  /// To be called before the forces of the step are applied. Appends the island to `snapshot`.
  void begin(std::span<btRigidBody* const> bodies, std::span<btPersistentManifold* const> manifolds, bool hasJoints,
             Snapshot& snapshot);
  /// To be called when the bodies have moved.
  /// @param start Of the island in `snapshot`.
  void end(std::span<btRigidBody* const> bodies, std::span<btPersistentManifold* const> manifolds, bool hasJoints,
           const Snapshot& snapshot, const Snapshot::Start& start);

 private:
  /// An island that a step left as it was; without bodies if it did not.
  struct UnchangedIsland {
    const btRigidBody* first = nullptr;
    std::size_t bodies = 0;
    std::size_t manifolds = 0;
    int points = 0;
    bool operator==(const UnchangedIsland&) const = default;
  };
  struct Record {
    bool isStill = false;
    std::atomic<bool> isDisturbed = true;
    UnchangedIsland island;
    /// Before the last step: velocities, and external forces.
    btVector3 linear, angular, force, torque;
  };

  static UnchangedIsland islandOf(std::span<btRigidBody* const> bodies,
                                  std::span<btPersistentManifold* const> manifolds);
  Record& recordOf(const btCollisionObject& object) const;

  std::size_t count_ = 0;
  std::size_t capacity_ = 0;
  std::unique_ptr<Record[]> records_;
};

}  // namespace pongsim::physics
