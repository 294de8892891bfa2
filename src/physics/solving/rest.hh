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

/// Knows which groups of bodies a step would leave as they are, to the bit: state and inputs are those of the step
/// before, and that step changed nothing. Such a step need not be made; the result is the same. Groups with joints are
/// always solved.
///
/// Bodies are known by their island tags: their numbers where forces move them, else -1. What is asked and told on
/// several threads at once is of different groups, but for `disturb`.
class Rest {
 public:
  /// There are so many bodies that forces move. Where none has gone the first `kept` of them are those of before, else
  /// nothing is known any more.
  void resize(std::size_t kept, std::size_t bodies);
  /// Forgets all that is known.
  void forget() { resize(0, count_); }

  /// @return Whether the object is where it was when the last step looked for contacts.
  bool isStill(const btCollisionObject& object) const;
  /// The object's contacts are not those of the step before.
  void disturb(const btCollisionObject& object);

  /// Asks for the memory of what is known of a body that has joints.
  void prefetch(std::size_t body) const { base::prefetch(records_[body], offsetof(Record, linear)); }

  /// What groups are before a step, one after the other; memory for one thread.
  struct alignas(64) Before {
    /// Where what is kept of a group begins.
    struct Start {
      std::size_t places;
      std::size_t impulses;
    };
    std::vector<btTransform> places;
    std::vector<double> impulses;

    Start end() const { return {places.size(), impulses.size()}; }
    void clear() {
      places.clear();
      impulses.clear();
    }
  };
  /// @return Whether the coming step would leave the group as it is.
  bool isSettled(std::span<btCollisionObject* const> bodies, std::span<btPersistentManifold* const> manifolds) const;
  /// To be called before forces of the step are put on the bodies. Appends the group to `before`.
  void begin(std::span<btCollisionObject* const> bodies, std::span<btPersistentManifold* const> manifolds,
             bool hasJoints, Before& before);
  /// To be called when the bodies have moved.
  /// @param start Of the group in `before`.
  void end(std::span<btCollisionObject* const> bodies, std::span<btPersistentManifold* const> manifolds, bool hasJoints,
           const Before& before, const Before::Start& start);

 private:
  /// Of a group that a step left as it was; no bodies where it did not.
  struct Group {
    const btCollisionObject* first = nullptr;
    std::size_t bodies = 0;
    std::size_t manifolds = 0;
    int points = 0;
    bool operator==(const Group&) const = default;
  };
  struct Record {
    bool isStill = false;
    std::atomic<bool> isDisturbed = true;
    Group group;
    /// Before the last step: velocities, and forces of others.
    btVector3 linear, angular, force, torque;
  };

  static Group groupOf(std::span<btCollisionObject* const> bodies, std::span<btPersistentManifold* const> manifolds);
  Record& recordOf(const btCollisionObject& object) const {
    return records_[static_cast<std::size_t>(object.getIslandTag())];
  }

  std::size_t count_ = 0;
  std::size_t capacity_ = 0;
  std::unique_ptr<Record[]> records_;
};

}  // namespace pongsim::physics
