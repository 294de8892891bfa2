#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/workers.hh"
#include "physics/rest.hh"

namespace pongsim::physics {

/// What is done to a group of bodies that hold or touch each other, beside solving it.
class GroupWork {
 public:
  virtual ~GroupWork() = default;
  /// @return At how many points the two may touch.
  virtual long long mostContacts(const btPersistentManifold& manifold) const = 0;
  /// Puts the forces of the coming step of `dt` [s] on the bodies. Groups may be prepared on several threads at once.
  virtual void prepare(std::span<btCollisionObject* const> bodies, std::span<btTypedConstraint* const> joints,
                       double dt) = 0;
  /// Likewise, when the bodies are where the step has moved them.
  virtual void finish(std::span<btCollisionObject* const> bodies, std::span<btTypedConstraint* const> joints) = 0;
};

/// A Bullet world that solves each group of bodies that hold or touch each other by itself, bodies, points of contact
/// and joints always in the same order, whatever happened before: that of the links' and joints' slots. What Bullet's
/// own grouping gives depends on the order in which pairs have come near each other, and so on a past that no saved
/// state has. Groups share nothing but bodies that do not move, so that it makes no difference to the result which of
/// several threads takes which, and when.
class GroupedWorld final : public btDiscreteDynamicsWorld {
 public:
  /// @param solvers One for each of the `workers`.
  GroupedWorld(btDispatcher& dispatcher, btBroadphaseInterface& broadphase, btCollisionConfiguration& configuration,
               std::vector<std::unique_ptr<btConstraintSolver>> solvers, base::Workers& workers, Rest& rest,
               GroupWork& work);

  /// Sets which bodies forces move, in the order of their slots.
  /// @param first So many stay as they are; `bodies` stand behind them.
  void setBodies(std::size_t first, std::span<btRigidBody* const> bodies);
  /// Likewise which joints are solved. Bullet's own list of joints is not used.
  void setJoints(std::size_t first, std::span<btTypedConstraint* const> joints);

 protected:
  // gravity is among the forces of `GroupWork`, and each group is moved once it is solved
  void applyGravity() override {}
  void integrateTransforms(btScalar) override {}
  void calculateSimulationIslands() override {}
  void updateActivationState(btScalar) override {}
  void createPredictiveContacts(btScalar) override {}
  void predictUnconstraintMotion(btScalar dt) override;
  void saveKinematicState(btScalar dt) override;
  void updateAabbs() override;
  void solveConstraints(btContactSolverInfo& info) override;

 private:
  struct Touch {
    /// Slots of the links, the smaller one first, and the parts that touch.
    std::uint64_t links;
    std::uint64_t parts;
    btPersistentManifold* manifold;
  };
  /// A point of contact, and how far it is from those that are kept, squared.
  struct Point {
    btPersistentManifold* manifold;
    int index;
    double distance;
    bool isKept;
  };
  /// Numbers of members, or places of the first ones.
  struct Group {
    std::size_t bodies = 0;
    std::size_t manifolds = 0;
    std::size_t joints = 0;
  };

  struct Aabb {
    btVector3 lowest;
    btVector3 highest;
    /// It is that of the step before.
    bool isKept = false;
  };
  /// @return What holds the body where it is now and where it is going.
  static Aabb aabbOf(const btRigidBody& body);

  /// Calls `work(body, its number)` for each moving body, shared out among the workers.
  template <class Work>
  void forEachBody(Work&& work);
  void solveGroup(std::size_t group, std::size_t worker, const btContactSolverInfo& info);
  void collectTouches();
  void limitContacts(btPersistentManifold& manifold) const;
  void limitContactsOfPieces();
  /// Leaves that many points.
  /// @return Whether a manifold has none any more.
  bool keepSpread(std::span<const Touch> touches, std::size_t most);
  void uniteBodies();
  void countMembers();
  void sortByGroup();
  std::size_t rootOf(std::size_t body);
  void unite(const btCollisionObject& a, const btCollisionObject& b);
  /// Of whichever of the two forces move.
  std::size_t groupOf(const btCollisionObject& a, const btCollisionObject& b) const;
  std::size_t groupOf(const btPersistentManifold& manifold) const;
  std::size_t groupOf(const btTypedConstraint& joint) const;

  std::vector<std::unique_ptr<btConstraintSolver>> solvers_;
  base::Workers& workers_;
  Rest& rest_;
  /// One for each worker.
  std::vector<Rest::Before> before_;
  GroupWork& work_;

  std::vector<btRigidBody*> bodies_;
  std::vector<btTypedConstraint*> joints_;
  std::vector<Touch> touches_;
  /// Of two collisions.
  std::vector<Point> points_;

  /// Of each body, one that it is connected with and that stands before it, or itself.
  std::vector<std::size_t> parents_;
  std::vector<std::size_t> groupOfBody_;
  /// One more than there are, for the end of the last.
  std::vector<Group> groups_;
  std::vector<Group> next_;
  std::vector<btCollisionObject*> bodiesByGroup_;
  std::vector<btPersistentManifold*> manifoldsByGroup_;
  std::vector<btTypedConstraint*> jointsByGroup_;

  /// Of each moving body; new where the bodies have not moved since.
  std::vector<Aabb> aabbs_;
  bool aabbsAreNew_ = false;
};

}  // namespace pongsim::physics
