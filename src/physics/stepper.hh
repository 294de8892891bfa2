#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/arena.hh"
#include "physics/body.hh"
#include "physics/contacts/collision_configuration.hh"
#include "physics/contacts/collision_detection.hh"
#include "physics/contacts/contact_limits.hh"
#include "physics/islands/islands.hh"
#include "physics/islands/neighbourhoods.hh"
#include "physics/islands/rest.hh"
#include "physics/joint.hh"
#include "physics/settings.hh"
#include "physics/solving/island_solver.hh"
#include "pongsim/state/state_archive.hh"
#include "shared/threads/workers.hh"
#include "world/state.hh"

namespace pongsim::physics {

/// Makes steps. A step goes neighbourhood by neighbourhood: one thread finds where its bodies touch, solves its
/// islands, moves them and computes their boxes for the next step, while all of that is in its processor's cache. Only
/// crowds are shared out among the threads: first their pairs, then their islands.
///
/// Each island is solved by itself, with bodies, contact points and joints in the order of the links' and joints'
/// slots. (The order of Bullet's islands depends on the order in which pairs have come near each other, and so on a
/// past that no saved state has.) Islands have only fixed bodies in common, so the result does not depend on which
/// thread solves which island when.
class Stepper {
 public:
  /// @param configuration Must outlive this, as `arena` must; may be used again afterwards.
  Stepper(const Settings& settings, CollisionConfiguration& configuration, base::Arena& arena);

  CollisionDetection& collisions() { return collisions_; }

  /// Sets the bodies that forces move, in the order of their slots: the first `kept` stay, these follow.
  void setBodies(std::size_t kept, std::span<Body* const> bodies);
  /// Likewise the joints between them.
  void setJoints(std::size_t kept, std::span<Joint* const> joints);

  /// To be called when a body was given a velocity.
  void forgetBox(const Body& body);
  /// Wakes resting islands after an external change.
  void forgetRest();

  /// Finds the contacts of all bodies at their current poses.
  void findTouches() { collisions_.findTouches(rigidBodies_, dispatchInfo_); }
  /// Saves the contact points, or replaces those found at the current poses by saved ones.
  void transferContacts(StateArchive& archive);

  /// Makes a step of exactly `dt` [s], and writes the bodies' and joints' states.
  void step(double dt, world::State& state);

  /// @return The first link whose motion has become infinite or NaN in the last step; else `world::kNoSlot`.
  world::Slot exploded() const { return exploded_; }
  /// @return The first link that was slowed down in the last step; else `world::kNoSlot`.
  world::Slot slowedDown() const { return slowedDown_; }

 private:
  /// The touches of a batch or of the crowds, and the islands that follow from them. Bodies have the numbers of their
  /// places there.
  struct Touching {
    std::vector<Touch> touches;
    std::vector<Islands::Ends> touchEnds;
    std::vector<Islands::Ends> jointEnds;
    Islands islands;
  };
  /// Numbers of each, or where some begin.
  struct Counts {
    std::size_t bodies = 0;
    std::size_t manifolds = 0;
    std::size_t joints = 0;
  };
  /// An island to be solved, and where its members begin and end in `Gathered`.
  struct Solved {
    std::size_t island;
    Counts begin;
    Counts end;
    Rest::Snapshot::Start snapshot;
  };
  /// The members of islands, one island after the other.
  struct Gathered {
    std::vector<btRigidBody*> bodies;
    std::vector<btPersistentManifold*> manifolds;
    std::vector<Joint*> joints;

    Counts end() const { return {bodies.size(), manifolds.size(), joints.size()}; }
    std::span<btRigidBody* const> bodiesOf(const Solved& solved) const {
      return std::span(bodies).subspan(solved.begin.bodies, solved.end.bodies - solved.begin.bodies);
    }
    std::span<btPersistentManifold* const> manifoldsOf(const Solved& solved) const {
      return std::span(manifolds).subspan(solved.begin.manifolds, solved.end.manifolds - solved.begin.manifolds);
    }
    std::span<Joint* const> jointsOf(const Solved& solved) const {
      return std::span(joints).subspan(solved.begin.joints, solved.end.joints - solved.begin.joints);
    }
  };
  /// A worker's solver and working memory, kept for the next step.
  struct alignas(64) Scratch {
    explicit Scratch(const Settings& settings) : solver(settings) {}
    IslandSolver solver;
    std::vector<Touch> crowdTouches;
    Touching touching;
    std::vector<Touch> touches;
    Gathered gathered;
    std::vector<Solved> solved;
    PieceLimits pieces;
    Rest::Snapshot snapshot;
  };

  void dampBodies();
  void findJointEnds();
  void formNeighbourhoods();
  void findPairTouches(std::span<const std::uint32_t> pairs, std::size_t worker, std::vector<Touch>& touches);
  void findCrowdTouches(std::size_t chunk, std::size_t worker);
  void solveCrowds();
  /// Makes the whole step of a batch.
  void advance(const Neighbourhoods::Members& members, std::size_t worker);
  void formIslands(const Neighbourhoods::Members& members, Touching& touching) const;
  /// Appends an island to what is gathered.
  Solved gather(const Neighbourhoods::Members& members, const Touching& touching, std::size_t island,
                Scratch& scratch) const;
  /// Solves the islands from `first` to `end`: prepares all, solves all, finishes all, so that the code of each part
  /// stays in the processor's cache.
  void solveIslands(const Neighbourhoods::Members& members, const Touching& touching, std::size_t first,
                    std::size_t end, std::size_t worker);
  void prefetchIsland(const Neighbourhoods::Members& members, const Touching& touching, std::size_t island) const;
  void prefetchContacts(const Neighbourhoods::Members& members, const Touching& touching, std::size_t island) const;
  void prepareIsland(const Neighbourhoods::Members& members, const Touching& touching, std::size_t island,
                     Scratch& scratch);
  void finishIsland(const Neighbourhoods::Members& members, const Touching& touching, const Solved& solved,
                    Scratch& scratch);

  const Settings settings_;
  shared::Workers workers_;
  Rest rest_;
  CollisionDetection collisions_;
  /// One for each worker.
  std::vector<std::unique_ptr<Scratch>> scratches_;

  std::vector<Body*> bodies_;
  /// The same bodies.
  std::vector<btRigidBody*> rigidBodies_;
  /// Numbers of those that are damped.
  std::vector<std::size_t> damped_;
  std::vector<Joint*> joints_;
  /// Of each joint, unless bodies or joints have come, gone or moved up since.
  std::vector<Islands::Ends> jointEnds_;
  bool areJointEndsOld_ = false;
  /// Of each pair of the broad phase.
  std::vector<Islands::Ends> pairEnds_;
  Neighbourhoods neighbourhoods_;
  Touching crowds_;

  /// Length of the last step [s].
  double dt_ = 0;
  btDispatcherInfo dispatchInfo_;
  /// What the step writes to.
  world::State* state_ = nullptr;
  /// Only a step puts bodies to rest: without one since `forgetRest` there are none to wake.
  bool hasStepped_ = false;
  std::atomic<world::Slot> exploded_ = world::kNoSlot;
  std::atomic<world::Slot> slowedDown_ = world::kNoSlot;
};

}  // namespace pongsim::physics
