#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "shared/threads/workers.hh"
#include "physics/contacts/broad_phase.hh"
#include "physics/contacts/dispatcher.hh"
#include "physics/contacts/swept_boxes.hh"
#include "physics/solving/contact_limits.hh"
#include "physics/solving/groups.hh"
#include "physics/solving/neighbourhoods.hh"
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
///
/// A step goes neighbourhood by neighbourhood: one thread finds where its bodies touch, solves its groups, moves them
/// and finds their boxes for the next step, while all of that is in its processor's cache. The pairs of crowds are
/// shared out among the threads first, and then their groups.
class GroupedWorld final : public btDiscreteDynamicsWorld {
 public:
  /// @param solvers One for each of the `workers`.
  /// @param mostContacts At how many points two collisions may touch, where neither says how many; negative: no limit.
  GroupedWorld(Dispatcher& dispatcher, BroadPhase& broadPhase, btCollisionConfiguration& configuration,
               std::vector<std::unique_ptr<btConstraintSolver>> solvers, long long mostContacts, shared::Workers& workers,
               Rest& rest, GroupWork& work);

  /// Sets which bodies forces move, in the order of their slots.
  /// @param first So many stay as they are; `bodies` stand behind them.
  void setBodies(std::size_t first, std::span<btRigidBody* const> bodies);
  /// Likewise which joints are solved. Bullet's own list of joints is not used.
  void setJoints(std::size_t first, std::span<btTypedConstraint* const> joints);
  /// Removes bodies with their pairs and contacts, without allocating. To be used instead of `removeRigidBody`, which
  /// goes through all pairs twice for each body.
  void remove(std::span<btRigidBody* const> bodies);
  /// Removes all bodies.
  void clear();
  /// A body has been moved, or its velocity set, since the last step.
  void forgetBox(const btRigidBody& body);

  /// Makes a step of exactly `dt` [s].
  void step(double dt);
  void updateAabbs() override { boxes_.updateInPlace(bodies_, *this); }

 private:
  /// What touches in a neighbourhood or in the crowds, and the groups that follow from it. Bodies have the numbers of
  /// their places there.
  struct Touching {
    std::vector<Touch> touches;
    std::vector<Groups::Ends> touchEnds;
    std::vector<Groups::Ends> jointEnds;
    Groups groups;
  };
  /// How many there are of each, or where some begin.
  struct Counts {
    std::size_t bodies = 0;
    std::size_t manifolds = 0;
    std::size_t joints = 0;
  };
  /// A group that is solved, and where what is gathered of it begins and ends.
  struct Solved {
    std::size_t group;
    Counts begin;
    Counts end;
    Rest::Before::Start before;
  };
  /// What groups consist of, one after the other.
  struct Gathered {
    std::vector<btCollisionObject*> bodies;
    std::vector<btPersistentManifold*> manifolds;
    std::vector<btTypedConstraint*> joints;

    Counts end() const { return {bodies.size(), manifolds.size(), joints.size()}; }
    std::span<btCollisionObject*> bodiesOf(const Solved& solved) {
      return std::span(bodies).subspan(solved.begin.bodies, solved.end.bodies - solved.begin.bodies);
    }
    std::span<btPersistentManifold*> manifoldsOf(const Solved& solved) {
      return std::span(manifolds).subspan(solved.begin.manifolds, solved.end.manifolds - solved.begin.manifolds);
    }
    std::span<btTypedConstraint*> jointsOf(const Solved& solved) {
      return std::span(joints).subspan(solved.begin.joints, solved.end.joints - solved.begin.joints);
    }
  };
  /// What solving groups takes, kept for the next ones.
  struct alignas(64) Scratch {
    std::vector<Touch> crowdTouches;
    Touching touching;
    std::vector<Touch> touches;
    Gathered gathered;
    std::vector<Solved> solved;
    PieceLimits pieces;
    Rest::Before before;
  };

  void dampBodies(double dt);
  void findEnds();
  void formNeighbourhoods();
  void findTouches(std::span<const std::uint32_t> pairs, std::size_t worker, std::vector<Touch>& touches);
  void findCrowdTouches(std::size_t chunk, std::size_t worker);
  void solveCrowds();
  /// Makes a whole step of a batch.
  void advance(const Neighbourhoods::Members& members, std::size_t worker);
  void formGroups(const Neighbourhoods::Members& members, Touching& touching) const;
  /// @return What stands behind that of the groups before.
  Solved gather(const Neighbourhoods::Members& members, const Touching& touching, std::size_t group,
                Scratch& scratch) const;
  /// Solves the groups from `first` to `end`, each part of that for all of them before the next part, so that its code
  /// stays in the processor's cache.
  void solveGroups(const Neighbourhoods::Members& members, const Touching& touching, std::size_t first, std::size_t end,
                   std::size_t worker);
  void prepareGroup(const Neighbourhoods::Members& members, const Touching& touching, std::size_t group,
                    Scratch& scratch);
  void finishGroup(const Neighbourhoods::Members& members, const Touching& touching, const Solved& solved,
                   Scratch& scratch);
  // these ask for the memory of a group, if there is such a one: some at a time, for a processor waits for who asks for
  // too much at once
  void prefetchBodies(const Neighbourhoods::Members& members, const Touching& touching, std::size_t group) const;
  void prefetchJoints(const Neighbourhoods::Members& members, const Touching& touching, std::size_t group) const;
  void prefetchSurfaces(const Neighbourhoods::Members& members, const Touching& touching, std::size_t group) const;

  const std::vector<std::unique_ptr<btConstraintSolver>> solvers_;
  const long long mostContacts_;
  Dispatcher& dispatcher_;
  BroadPhase& broadPhase_;
  shared::Workers& workers_;
  Rest& rest_;
  GroupWork& work_;
  SweptBoxes boxes_;
  /// One for each worker.
  std::vector<Scratch> scratches_;

  std::vector<btRigidBody*> bodies_;
  /// Numbers of those that are damped.
  std::vector<std::size_t> damped_;
  std::vector<btTypedConstraint*> joints_;
  /// Of each joint; new only once they are found anew where bodies or joints have come, gone or moved up.
  std::vector<Groups::Ends> ends_;
  bool endsAreOld_ = false;
  /// Likewise of each pair of the broad phase.
  std::vector<Groups::Ends> pairEnds_;
  /// Those themselves, while a step is made.
  btBroadphasePair* pairs_ = nullptr;
  Neighbourhoods neighbourhoods_;
  Touching crowds_;
};

}  // namespace pongsim::physics
