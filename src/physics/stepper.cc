#include "physics/stepper.hh"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <algorithm>
#include <cassert>
#include <functional>
#include <utility>

#include "base/prefetch.hh"
#include "physics/contacts/manifold_state.hh"
#include "physics/motion.hh"
#include "physics/rounding.hh"
#include "pongsim/math.hh"

namespace pongsim::physics {

namespace {

/// Pairs of a crowd that a worker takes at a time: fetching them one by one costs too much.
constexpr std::size_t kCrowdPairsAtATime = 16;
/// Batches of neighbourhoods for each worker, if there are several: with fewer, some wait longer for the last one.
constexpr std::size_t kBatchesOfAWorker = 16;
/// Islands that are solved together: the data of more of them does not fit in the nearest cache.
constexpr std::size_t kIslandsTogether = 8;

/// @return The fraction of a speed that is left after `dt` [s], if 1 - `damping` is left after a second.
double leftAfter(double dt, double damping) { return math::exp(dt * math::log1p(-damping)); }

// like btRigidBody::applyDamping, which calls the C library's pow
void damp(btRigidBody& body, double dt) {
  body.setLinearVelocity(body.getLinearVelocity() * leftAfter(dt, body.getLinearDamping()));
  body.setAngularVelocity(body.getAngularVelocity() * leftAfter(dt, body.getAngularDamping()));
}

bool isDamped(const btRigidBody& body) { return body.getLinearDamping() != 0 || body.getAngularDamping() != 0; }

// Rounding keeps the bits of a resting body from step to step. The inertia is updated with the next step's forces.
void integrate(btRigidBody& body, double dt) {
  body.setLinearVelocity(roundedVelocity(body.getLinearVelocity()));
  body.setAngularVelocity(roundedVelocity(body.getAngularVelocity()));
  body.getWorldTransform() = moved(body.getWorldTransform(), body.getLinearVelocity(), body.getAngularVelocity(), dt);
}

void keepFirst(std::atomic<world::Slot>& first, world::Slot link) {
  world::Slot before = first;
  while (link < before && !first.compare_exchange_weak(before, link)) {
  }
}

// With hundreds of robots, what a pair or island needs is in no near cache, so it is prefetched while those before are
// processed: of pairs first the proxies and, once these are there, what they point to, and then the manifolds.
void prefetchProxies(const btBroadphasePair& pair) {
  base::prefetch(*static_cast<const btDbvtProxy*>(pair.m_pProxy0));
  base::prefetch(*static_cast<const btDbvtProxy*>(pair.m_pProxy1));
}
void prefetchObjects(const btBroadphasePair& pair) {
  for (const btBroadphaseProxy* proxy : {pair.m_pProxy0, pair.m_pProxy1}) {
    base::prefetch(*static_cast<const btCollisionObject*>(proxy->m_clientObject));
  }
  if (pair.m_algorithm != nullptr) base::prefetch(*pair.m_algorithm);
}

}  // namespace

Stepper::Stepper(const Settings& settings, CollisionConfiguration& configuration, base::Arena& arena)
    : settings_(settings),
      workers_(settings.threads),
      collisions_(configuration, arena, workers_, rest_, settings.maxContacts) {
  for (int i = 0; i < settings.threads; ++i) scratches_.push_back(std::make_unique<Scratch>(settings));
}

void Stepper::setBodies(std::size_t kept, std::span<Body* const> bodies) {
  assert(kept <= bodies_.size());
  bodies_.resize(kept);
  bodies_.insert(bodies_.end(), bodies.begin(), bodies.end());
  rigidBodies_.resize(kept);
  damped_.erase(std::ranges::lower_bound(damped_, kept), damped_.end());
  for (std::size_t i = kept; i < bodies_.size(); ++i) {
    assert(bodies_[i]->moves() && (i == 0 || bodies_[i - 1]->link() < bodies_[i]->link()));
    btRigidBody& body = bodies_[i]->rigid();
    rigidBodies_.push_back(&body);
    body.setIslandTag(static_cast<int>(i));
    if (isDamped(body)) damped_.push_back(i);
  }
  areJointEndsOld_ = true;
  rest_.resize(kept, bodies_.size());
  collisions_.boxes().resize(kept, bodies_.size());
}

void Stepper::setJoints(std::size_t kept, std::span<Joint* const> joints) {
  assert(kept <= joints_.size());
  joints_.resize(kept);
  joints_.insert(joints_.end(), joints.begin(), joints.end());
  areJointEndsOld_ = true;
}

void Stepper::forgetBox(const Body& body) {
  if (body.moves()) collisions_.boxes().forget(static_cast<std::size_t>(body.rigid().getIslandTag()));
}

// callers that move thousands of bodies call this for each
void Stepper::forgetRest() {
  if (std::exchange(hasStepped_, false)) rest_.forget();
}

void Stepper::transferContacts(StateArchive& archive) {
  // which algorithms and manifolds exist follows from the poses
  if (archive.isGiving()) findTouches();
  transferManifolds(archive, collisions_.dispatcher());
}

void Stepper::step(double dt, world::State& state) {
  // a resting island has written its state to another place, or rests for steps of another length
  if (dt_ != dt || state_ != &state) forgetRest();
  dt_ = dt;
  state_ = &state;
  hasStepped_ = true;
  slowedDown_ = exploded_ = world::kNoSlot;
  dispatchInfo_.m_timeStep = dt;
  dampBodies();
  collisions_.boxes().update(rigidBodies_, dt);
  collisions_.broadPhase().findRefusedPairs(rigidBodies_);
  collisions_.broadPhase().optimize();
  formNeighbourhoods();
  const std::size_t chunks = (neighbourhoods_.crowds().pairs.size() + kCrowdPairsAtATime - 1) / kCrowdPairsAtATime;
  workers_.forEach(chunks + neighbourhoods_.batchCount(), [&](std::size_t i, int number) {
    const auto worker = static_cast<std::size_t>(number);
    if (i < chunks) {
      findCrowdTouches(i, worker);
    } else {
      advance(neighbourhoods_.batch(i - chunks), worker);
    }
  });
  if (!neighbourhoods_.crowds().bodies.empty()) solveCrowds();
  collisions_.dispatcher().removeParted(*collisions_.broadPhase().getOverlappingPairCache());
}

// their boxes are computed here, because their velocities have changed since the end of the last step
void Stepper::dampBodies() {
  workers_.forEach(damped_.size(), [&](std::size_t i, int) {
    btRigidBody& body = *rigidBodies_[damped_[i]];
    damp(body, dt_);
    collisions_.boxes().sweep(body, damped_[i], dt_);
  });
}

void Stepper::findJointEnds() {
  jointEnds_.clear();
  for (const Joint* joint : joints_) {
    const btRigidBody* const reference = joint->reference();
    jointEnds_.push_back({joint->parent().getIslandTag(), joint->child().getIslandTag(),
                          reference == nullptr ? kNoMember : reference->getIslandTag()});
  }
}

void Stepper::formNeighbourhoods() {
  btOverlappingPairCache& cache = *collisions_.broadPhase().getOverlappingPairCache();
  const auto count = static_cast<std::size_t>(cache.getNumOverlappingPairs());
  // if pairs have gone, there are fewer
  const bool arePairsOld = collisions_.broadPhase().takeNewPairs() || count != pairEnds_.size();
  if (!arePairsOld && !areJointEndsOld_) return;
  if (std::exchange(areJointEndsOld_, false)) findJointEnds();
  pairEnds_.clear();
  for (const btBroadphasePair& pair : std::span(cache.getOverlappingPairArrayPtr(), count)) {
    pairEnds_.push_back(Dispatcher::numbersOf(pair));
  }
  const auto workers = static_cast<std::size_t>(workers_.count());
  neighbourhoods_.form(bodies_.size(), pairEnds_, jointEnds_, workers == 1 ? 1 : kBatchesOfAWorker * workers);
}

void Stepper::findPairTouches(std::span<const std::uint32_t> pairs, std::size_t worker, std::vector<Touch>& touches) {
  btBroadphasePair* const all = collisions_.broadPhase().getOverlappingPairCache()->getOverlappingPairArrayPtr();
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    constexpr std::size_t kFar = 8, kNear = 4, kNext = 2;
    if (i + kFar < pairs.size()) prefetchProxies(all[pairs[i + kFar]]);
    if (i + kNear < pairs.size()) {
      prefetchObjects(all[pairs[i + kNear]]);
      rest_.prefetch(pairEnds_[pairs[i + kNear]].first);
      rest_.prefetch(pairEnds_[pairs[i + kNear]].second);
    }
    if (i + kNext < pairs.size()) collisions_.dispatcher().prefetchManifolds(all[pairs[i + kNext]], worker);
    collisions_.dispatcher().findTouches(all[pairs[i]], dispatchInfo_, worker, touches);
  }
}

void Stepper::findCrowdTouches(std::size_t chunk, std::size_t worker) {
  const std::span<const std::uint32_t> pairs = neighbourhoods_.crowds().pairs;
  const std::size_t begin = chunk * kCrowdPairsAtATime;
  findPairTouches(pairs.subspan(begin, std::min(kCrowdPairsAtATime, pairs.size() - begin)), worker,
                  scratches_[worker]->crowdTouches);
}

void Stepper::solveCrowds() {
  crowds_.touches.clear();
  for (const auto& scratch : scratches_) {
    crowds_.touches.insert(crowds_.touches.end(), scratch->crowdTouches.begin(), scratch->crowdTouches.end());
    scratch->crowdTouches.clear();
    // a worker's share differs from step to step, and a step must not allocate
    scratch->crowdTouches.reserve(static_cast<std::size_t>(collisions_.dispatcher().getNumManifolds()));
  }
  const Neighbourhoods::Members members = neighbourhoods_.crowds();
  formIslands(members, crowds_);
  workers_.forEach(crowds_.islands.count(), [&](std::size_t island, int worker) {
    solveIslands(members, crowds_, island, island + 1, static_cast<std::size_t>(worker));
  });
}

void Stepper::advance(const Neighbourhoods::Members& members, std::size_t worker) {
  Touching& touching = scratches_[worker]->touching;
  touching.touches.clear();
  findPairTouches(members.pairs, worker, touching.touches);
  formIslands(members, touching);
  const std::size_t count = touching.islands.count();
  for (std::size_t first = 0; first < count; first += kIslandsTogether) {
    solveIslands(members, touching, first, std::min(first + kIslandsTogether, count), worker);
  }
}

void Stepper::formIslands(const Neighbourhoods::Members& members, Touching& touching) const {
  touching.touchEnds.clear();
  touching.jointEnds.clear();
  for (const Touch& touch : touching.touches) {
    touching.touchEnds.push_back(neighbourhoods_.placesOf({touch.a, touch.b}));
  }
  for (const std::uint32_t joint : members.joints) {
    touching.jointEnds.push_back(neighbourhoods_.placesOf(jointEnds_[joint]));
  }
  touching.islands.form(members.bodies.size(), touching.touchEnds, touching.jointEnds);
}

Stepper::Solved Stepper::gather(const Neighbourhoods::Members& members, const Touching& touching, std::size_t island,
                                Scratch& scratch) const {
  auto& [bodies, manifolds, joints] = scratch.gathered;
  Solved solved{island, scratch.gathered.end(), {}, scratch.snapshot.end()};
  for (const std::uint32_t place : touching.islands.bodies(island)) {
    bodies.push_back(rigidBodies_[members.bodies[place]]);
  }
  for (const std::uint32_t place : touching.islands.joints(island)) {
    joints.push_back(joints_[members.joints[place]]);
  }
  scratch.touches.clear();
  for (const std::uint32_t touch : touching.islands.touches(island)) {
    scratch.touches.push_back(touching.touches[touch]);
  }
  std::ranges::sort(scratch.touches, std::less<>());
  const std::size_t count = scratch.pieces.limit(scratch.touches, settings_.maxContacts);
  for (std::size_t i = 0; i < count; ++i) manifolds.push_back(scratch.touches[i].manifold);
  solved.end = scratch.gathered.end();
  return solved;
}

void Stepper::solveIslands(const Neighbourhoods::Members& members, const Touching& touching, std::size_t first,
                           std::size_t end, std::size_t worker) {
  Scratch& scratch = *scratches_[worker];
  Gathered& gathered = scratch.gathered;
  gathered.bodies.clear();
  gathered.manifolds.clear();
  gathered.joints.clear();
  scratch.solved.clear();
  scratch.snapshot.clear();
  for (std::size_t island = first; island < end; ++island) {
    prefetchIsland(members, touching, island + 1);
    prepareIsland(members, touching, island, scratch);
  }
  for (const Solved& solved : scratch.solved) {
    prefetchContacts(members, touching, solved.island + 1);
    scratch.solver.solve(gathered.bodiesOf(solved), gathered.manifoldsOf(solved), gathered.jointsOf(solved), dt_);
  }
  for (const Solved& solved : scratch.solved) finishIsland(members, touching, solved, scratch);
}

void Stepper::prefetchIsland(const Neighbourhoods::Members& members, const Touching& touching,
                             std::size_t island) const {
  if (island >= touching.islands.count()) return;
  for (const std::uint32_t place : touching.islands.bodies(island)) base::prefetch(*bodies_[members.bodies[place]]);
  for (const std::uint32_t place : touching.islands.joints(island)) base::prefetch(*joints_[members.joints[place]]);
}

void Stepper::prefetchContacts(const Neighbourhoods::Members& members, const Touching& touching,
                               std::size_t island) const {
  if (island >= touching.islands.count()) return;
  for (const std::uint32_t place : touching.islands.bodies(island)) {
    const Body& body = *bodies_[members.bodies[place]];
    body.shape().prefetch();
    base::prefetch(*static_cast<const btDbvtProxy*>(body.rigid().getBroadphaseProxy())->leaf);
  }
}

/// Applies the forces of the step, unless the island rests and so need not be solved.
void Stepper::prepareIsland(const Neighbourhoods::Members& members, const Touching& touching, std::size_t island,
                            Scratch& scratch) {
  const Solved solved = gather(members, touching, island, scratch);
  const auto bodies = scratch.gathered.bodiesOf(solved);
  const auto manifolds = scratch.gathered.manifoldsOf(solved);
  const auto joints = scratch.gathered.jointsOf(solved);
  if (joints.empty() && rest_.isSettled(bodies, manifolds)) {
    for (btRigidBody* body : bodies) body->clearForces();
    return;
  }
  rest_.begin(bodies, manifolds, !joints.empty(), scratch.snapshot);
  for (Joint* joint : joints) joint->prepare(dt_);
  for (const std::uint32_t place : touching.islands.bodies(island)) {
    bodies_[members.bodies[place]]->addForces(dt_, !joints.empty());
  }
  scratch.solved.push_back(solved);
}

/// Moves the bodies, writes their states, and computes their boxes for the next step.
void Stepper::finishIsland(const Neighbourhoods::Members& members, const Touching& touching, const Solved& solved,
                           Scratch& scratch) {
  const auto bodies = scratch.gathered.bodiesOf(solved);
  const auto joints = scratch.gathered.jointsOf(solved);
  for (btRigidBody* body : bodies) integrate(*body, dt_);
  for (const std::uint32_t place : touching.islands.bodies(solved.island)) {
    Body& body = *bodies_[members.bodies[place]];
    if (body.slowDown(dt_)) keepFirst(slowedDown_, body.link());
    if (!body.read(state_->links[body.link()])) keepFirst(exploded_, body.link());
  }
  for (Joint* joint : joints) {
    joint->update();
    state_->joints[joint->slot()] = joint->state();
  }
  rest_.end(bodies, scratch.gathered.manifoldsOf(solved), !joints.empty(), scratch.snapshot, solved.snapshot);
  for (const std::uint32_t place : touching.islands.bodies(solved.island)) {
    const std::uint32_t number = members.bodies[place];
    if (!isDamped(*rigidBodies_[number])) collisions_.boxes().sweep(*rigidBodies_[number], number, dt_);
  }
  for (btRigidBody* body : bodies) body->clearForces();
}

}  // namespace pongsim::physics
