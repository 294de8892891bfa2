#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pongsim::physics {

/// A Bullet world that solves each group of bodies that hold or touch each other by itself, bodies, points of contact
/// and joints always in the same order, whatever happened before: that of the links' and joints' slots. What Bullet's
/// own grouping gives depends on the order in which pairs have come near each other, and so on a past that no saved
/// state has.
class GroupedWorld final : public btDiscreteDynamicsWorld {
 public:
  using btDiscreteDynamicsWorld::btDiscreteDynamicsWorld;

  /// Sets which bodies forces move, and which joints are solved, in the order of their slots. Bullet's own list of
  /// joints is not used.
  void setMembers(std::vector<btRigidBody*> bodies, std::vector<btTypedConstraint*> joints);

 protected:
  void calculateSimulationIslands() override {}
  void updateActivationState(btScalar) override {}
  void solveConstraints(btContactSolverInfo& info) override;

 private:
  struct Touch {
    /// Slots of the links, the smaller one first, and the parts that touch.
    std::uint64_t links;
    std::uint64_t parts;
    btPersistentManifold* manifold;
  };
  /// Numbers of members, or places of the first ones.
  struct Group {
    std::size_t bodies = 0;
    std::size_t manifolds = 0;
    std::size_t joints = 0;
  };

  void collectTouches();
  void uniteBodies();
  void countMembers();
  void sortByGroup();
  std::size_t rootOf(std::size_t body);
  void unite(const btCollisionObject& a, const btCollisionObject& b);
  /// Of whichever of the two forces move.
  std::size_t groupOf(const btCollisionObject& a, const btCollisionObject& b) const;
  std::size_t groupOf(const btPersistentManifold& manifold) const;
  std::size_t groupOf(const btTypedConstraint& joint) const;

  std::vector<btRigidBody*> bodies_;
  std::vector<btTypedConstraint*> joints_;
  std::vector<Touch> touches_;

  /// Of each body, one that it is connected with and that stands before it, or itself.
  std::vector<std::size_t> parents_;
  std::vector<std::size_t> groupOfBody_;
  /// One more than there are, for the end of the last.
  std::vector<Group> groups_;
  std::vector<Group> next_;
  std::vector<btCollisionObject*> bodiesByGroup_;
  std::vector<btPersistentManifold*> manifoldsByGroup_;
  std::vector<btTypedConstraint*> jointsByGroup_;
};

}  // namespace pongsim::physics
