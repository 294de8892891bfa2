#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/workers.hh"
#include "physics/contacts/broad_phase.hh"
#include "physics/contacts/dispatcher.hh"
#include "physics/solving/contact_limits.hh"
#include "physics/solving/groups.hh"
#include "physics/solving/rest.hh"

namespace pongsim::physics {

/// What is done to a group of bodies that hold or touch each other, beside solving it.
class GroupWork {
 public:
  virtual ~GroupWork() = default;
  /// Puts the forces of the coming step of `dt` [s] on the bodies. Groups may be prepared on several threads at once.
  virtual void prepare(std::span<btCollisionObject* const> bodies, std::span<btTypedConstraint* const> joints,
                       double dt) = 0;
  /// Likewise, when the bodies are where the step has moved them.
  virtual void finish(std::span<btCollisionObject* const> bodies, std::span<btTypedConstraint* const> joints) = 0;
  /// Asks for the memory of what will be prepared soon.
  /// @param member Number of a body among those that forces move.
  virtual void prefetch(std::size_t member) const = 0;
  virtual void prefetch(const btTypedConstraint& joint) const = 0;
  /// Likewise of what its surfaces are, once the body itself is there.
  virtual void prefetchSurface(std::size_t member) const = 0;
};

/// A Bullet world that solves each group of bodies that hold or touch each other by itself, bodies, points of contact
/// and joints always in the same order, whatever happened before: that of the links' and joints' slots. What Bullet's
/// own grouping gives depends on the order in which pairs have come near each other, and so on a past that no saved
/// state has. Groups share nothing but bodies that do not move, so that it makes no difference to the result which of
/// several threads takes which, and when.
class GroupedWorld final : public btDiscreteDynamicsWorld {
 public:
  /// @param solvers One for each of the `workers`.
  /// @param mostContacts At how many points two collisions may touch, where neither says how many; negative: no limit.
  GroupedWorld(Dispatcher& dispatcher, BroadPhase& broadPhase, btCollisionConfiguration& configuration,
               std::vector<std::unique_ptr<btConstraintSolver>> solvers, long long mostContacts, base::Workers& workers,
               Rest& rest, GroupWork& work);

  /// Sets which bodies forces move, in the order of their slots.
  /// @param first So many stay as they are; `bodies` stand behind them.
  void setBodies(std::size_t first, std::span<btRigidBody* const> bodies);
  /// Likewise which joints are solved. Bullet's own list of joints is not used.
  void setJoints(std::size_t first, std::span<btTypedConstraint* const> joints);

 protected:
  // gravity is among the forces of `GroupWork`, and each group is moved and its forces cleared once it is solved
  void applyGravity() override {}
  void clearForces() override {}
  void synchronizeMotionStates() override {}
  void integrateTransforms(btScalar) override {}
  void calculateSimulationIslands() override {}
  void updateActivationState(btScalar) override {}
  void createPredictiveContacts(btScalar) override {}
  void predictUnconstraintMotion(btScalar dt) override;
  // what is put somewhere is there at once; Bullet makes a speed of the rounding of its turn
  void saveKinematicState(btScalar) override {}
  void updateAabbs() override;
  void solveConstraints(btContactSolverInfo& info) override;

 private:
  /// What solving a group takes, kept for the next one.
  struct alignas(64) Scratch {
    std::vector<btCollisionObject*> bodies;
    std::vector<btPersistentManifold*> manifolds;
    std::vector<btTypedConstraint*> joints;
    PieceLimits pieces;
    Rest::Before before;
  };
  /// Whether a body's box in the broad phase's tree still holds it.
  enum class Stay : std::uint8_t { kYes, kNo, kAbsurd };

  Stay stayOf(btRigidBody& body) const;
  /// Calls `work(body, its number)` for each moving body, shared out among the workers.
  template <class Work>
  void forEachBody(Work&& work);
  void findEnds();
  void gather(std::size_t group, Scratch& scratch);
  void prefetchBodies(std::size_t now) const;
  // these ask for the memory of a group, if there is such a one: some at a time, for a processor waits for who asks for
  // too much at once
  void prefetchBodiesOf(std::size_t group) const;
  void prefetchHoldsOf(std::size_t group);
  void prefetchSurfacesOf(std::size_t group) const;
  void solveGroup(std::size_t group, std::size_t worker, const btContactSolverInfo& info);

  const std::vector<std::unique_ptr<btConstraintSolver>> solvers_;
  const long long mostContacts_;
  Dispatcher& dispatcher_;
  BroadPhase& broadPhase_;
  base::Workers& workers_;
  Rest& rest_;
  GroupWork& work_;
  /// One for each worker.
  std::vector<Scratch> scratches_;

  std::vector<btRigidBody*> bodies_;
  std::vector<btTypedConstraint*> joints_;
  /// Of each joint; new only once they are found anew where bodies or joints have come, gone or moved up.
  std::vector<Groups::Ends> ends_;
  bool endsAreOld_ = false;
  Groups groups_;

  /// Of each moving body; new where the bodies have not moved since.
  std::vector<Stay> stays_;
  bool staysAreNew_ = false;
};

}  // namespace pongsim::physics
