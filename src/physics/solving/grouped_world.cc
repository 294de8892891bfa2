#include "physics/solving/grouped_world.hh"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/ConstraintSolver/btConstraintSolver.h>
#include <BulletDynamics/ConstraintSolver/btTypedConstraint.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "physics/motion.hh"
#include "physics/solving/rounding.hh"
#include "pongsim/math.hh"

namespace pongsim::physics {

namespace {

/// How many pairs of a crowd a worker takes at a time: one is too little to be worth the asking.
constexpr std::size_t kPairsAtATime = 16;
/// Into how many batches the neighbourhoods are divided for each worker, where there are several: the fewer, the longer
/// one may wait for another at the end.
constexpr std::size_t kBatchesOfAWorker = 16;
/// How many groups of a batch are solved together: more of them need more of the nearest cache for their data.
constexpr std::size_t kGroupsTogether = 8;

/// @return How much of a speed is left after `dt`, of which 1 - `damping` is left after a second.
double leftAfter(double dt, double damping) { return math::exp(dt * math::log1p(-damping)); }

// as btRigidBody::applyDamping, which asks the C library for the power
void damp(btRigidBody& body, double dt) {
  body.setLinearVelocity(body.getLinearVelocity() * leftAfter(dt, body.getLinearDamping()));
  body.setAngularVelocity(body.getAngularVelocity() * leftAfter(dt, body.getAngularDamping()));
}

bool isDamped(const btRigidBody& body) { return body.getLinearDamping() != 0 || body.getAngularDamping() != 0; }

// what is rounded rests to the bit; the next step's forces bring the inertia along
void move(btRigidBody& body, double dt) {
  body.setLinearVelocity(roundedVelocity(body.getLinearVelocity()));
  body.setAngularVelocity(roundedVelocity(body.getAngularVelocity()));
  body.getWorldTransform() = moved(body.getWorldTransform(), body.getLinearVelocity(), body.getAngularVelocity(), dt);
}

}  // namespace

GroupedWorld::GroupedWorld(Dispatcher& dispatcher, BroadPhase& broadPhase, btCollisionConfiguration& configuration,
                           std::vector<std::unique_ptr<btConstraintSolver>> solvers, long long mostContacts,
                           shared::Workers& workers, Rest& rest, GroupWork& work)
    : btDiscreteDynamicsWorld(&dispatcher, &broadPhase, solvers.front().get(), &configuration),
      solvers_(std::move(solvers)),
      mostContacts_(mostContacts),
      dispatcher_(dispatcher),
      broadPhase_(broadPhase),
      workers_(workers),
      rest_(rest),
      work_(work),
      boxes_(broadPhase, workers),
      scratches_(solvers_.size()) {}

void GroupedWorld::setBodies(std::size_t first, std::span<btRigidBody* const> bodies) {
  bodies_.resize(first);
  bodies_.insert(bodies_.end(), bodies.begin(), bodies.end());
  for (std::size_t i = first; i < bodies_.size(); ++i) bodies_[i]->setIslandTag(static_cast<int>(i));
  endsAreOld_ = true;
  rest_.resize(first, bodies_.size());
  boxes_.resize(first, bodies_.size());
  damped_.erase(std::ranges::lower_bound(damped_, first), damped_.end());
  for (std::size_t i = first; i < bodies_.size(); ++i) {
    if (isDamped(*bodies_[i])) damped_.push_back(i);
  }
}

void GroupedWorld::setJoints(std::size_t first, std::span<btTypedConstraint* const> joints) {
  joints_.resize(first);
  joints_.insert(joints_.end(), joints.begin(), joints.end());
  endsAreOld_ = true;
}

void GroupedWorld::remove(std::span<btRigidBody* const> bodies) {
  if (bodies.empty()) return;
  for (btRigidBody* body : bodies) {
    // the last object takes its place
    const int index = body->getWorldArrayIndex();
    m_collisionObjects.swap(index, m_collisionObjects.size() - 1);
    m_collisionObjects.pop_back();
    if (index < m_collisionObjects.size()) m_collisionObjects[index]->setWorldArrayIndex(index);
    body->setWorldArrayIndex(-1);
  }
  const auto goes = [](const btBroadphaseProxy& proxy) {
    return static_cast<const btCollisionObject*>(proxy.m_clientObject)->getWorldArrayIndex() < 0;
  };
  broadPhase_.removePairs(goes, dispatcher_);
  for (btRigidBody* body : bodies) {
    broadPhase_.destroyProxy(body->getBroadphaseProxy(), &dispatcher_);
    body->setBroadphaseHandle(nullptr);
  }
  int kept = 0;
  for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i) {
    btRigidBody* const body = m_nonStaticRigidBodies[i];
    if (body->getBroadphaseHandle() != nullptr) m_nonStaticRigidBodies[kept++] = body;
  }
  m_nonStaticRigidBodies.resize(kept);
}

void GroupedWorld::clear() {
  broadPhase_.removePairs([](const btBroadphaseProxy&) { return true; }, dispatcher_);
  m_nonStaticRigidBodies.clear();
  while (m_collisionObjects.size() > 0) {
    btCollisionWorld::removeCollisionObject(m_collisionObjects[m_collisionObjects.size() - 1]);
  }
}

void GroupedWorld::forgetBox(const btRigidBody& body) {
  if (body.getIslandTag() >= 0) boxes_.forget(static_cast<std::size_t>(body.getIslandTag()));
}

// of all joints: any may hold a body that has another number now
void GroupedWorld::findEnds() {
  ends_.clear();
  for (const btTypedConstraint* joint : joints_) {
    ends_.emplace_back(joint->getRigidBodyA().getIslandTag(), joint->getRigidBodyB().getIslandTag());
  }
}

void GroupedWorld::step(double dt) {
  // asked for by who finds contacts and by who solves
  getDispatchInfo().m_timeStep = dt;
  getSolverInfo().m_timeStep = dt;
  dampBodies(dt);
  boxes_.update(bodies_, dt, *this);
  computeOverlappingPairs();
  formNeighbourhoods();
  pairs_ = getPairCache()->getOverlappingPairArrayPtr();
  const std::size_t chunks = (neighbourhoods_.crowds().pairs.size() + kPairsAtATime - 1) / kPairsAtATime;
  workers_.forEach(chunks + neighbourhoods_.batchCount(), [&](std::size_t i, int number) {
    const auto worker = static_cast<std::size_t>(number);
    if (i < chunks) {
      findCrowdTouches(i, worker);
    } else {
      advance(neighbourhoods_.batch(i - chunks), worker);
    }
  });
  if (!neighbourhoods_.crowds().bodies.empty()) solveCrowds();
  dispatcher_.removeParted(*getPairCache());
}

// their boxes are found here, for what they have at the end of a step is not what they move with in the next
void GroupedWorld::dampBodies(double dt) {
  workers_.forEach(damped_.size(), [&](std::size_t i, int) {
    damp(*bodies_[damped_[i]], dt);
    boxes_.sweep(*bodies_[damped_[i]], damped_[i], dt);
  });
}

void GroupedWorld::formNeighbourhoods() {
  const auto count = static_cast<std::size_t>(getPairCache()->getNumOverlappingPairs());
  // those that have gone make them fewer
  const bool pairsAreOld = broadPhase_.takeNewPairs() || count != pairEnds_.size();
  if (!pairsAreOld && !endsAreOld_) return;
  if (endsAreOld_) findEnds();
  endsAreOld_ = false;
  const btBroadphasePair* const pairs = getPairCache()->getOverlappingPairArrayPtr();
  pairEnds_.clear();
  for (std::uint32_t i = 0; i < count; ++i) {
    constexpr std::uint32_t kFar = 12, kNear = 6;
    if (i + kFar < count) Dispatcher::prefetchProxies(pairs[i + kFar]);
    if (i + kNear < count) Dispatcher::prefetchObjects(pairs[i + kNear]);
    pairEnds_.push_back(Dispatcher::numbersOf(pairs[i]));
  }
  const auto workers = static_cast<std::size_t>(workers_.count());
  neighbourhoods_.form(bodies_.size(), pairEnds_, ends_, workers == 1 ? 1 : kBatchesOfAWorker * workers);
}

void GroupedWorld::findTouches(std::span<const std::uint32_t> pairs, std::size_t worker, std::vector<Touch>& touches) {
  // of pairs that come soon, each time what the time before has led to
  constexpr std::size_t kFar = 8, kNear = 5, kNext = 2;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (i + kFar < pairs.size()) Dispatcher::prefetchProxies(pairs_[pairs[i + kFar]]);
    if (i + kNear < pairs.size()) Dispatcher::prefetchObjects(pairs_[pairs[i + kNear]]);
    if (i + kNext < pairs.size()) dispatcher_.prefetchManifolds(pairs_[pairs[i + kNext]], worker);
    dispatcher_.findTouches(pairs_[pairs[i]], getDispatchInfo(), worker, touches);
  }
}

void GroupedWorld::findCrowdTouches(std::size_t chunk, std::size_t worker) {
  const std::span<const std::uint32_t> pairs = neighbourhoods_.crowds().pairs;
  const std::size_t begin = chunk * kPairsAtATime;
  findTouches(pairs.subspan(begin, std::min(kPairsAtATime, pairs.size() - begin)), worker,
              scratches_[worker].crowdTouches);
}

void GroupedWorld::solveCrowds() {
  crowds_.touches.clear();
  for (Scratch& scratch : scratches_) {
    crowds_.touches.insert(crowds_.touches.end(), scratch.crowdTouches.begin(), scratch.crowdTouches.end());
    scratch.crowdTouches.clear();
    // who finds how much of it differs from step to step
    scratch.crowdTouches.reserve(static_cast<std::size_t>(dispatcher_.getNumManifolds()));
  }
  const Neighbourhoods::Members members = neighbourhoods_.crowds();
  formGroups(members, crowds_);
  workers_.forEach(crowds_.groups.count(), [&](std::size_t group, int worker) {
    solveGroups(members, crowds_, group, group + 1, static_cast<std::size_t>(worker));
  });
}

void GroupedWorld::advance(const Neighbourhoods::Members& members, std::size_t worker) {
  Touching& touching = scratches_[worker].touching;
  touching.touches.clear();
  findTouches(members.pairs, worker, touching.touches);
  formGroups(members, touching);
  const std::size_t count = touching.groups.count();
  for (std::size_t first = 0; first < count; first += kGroupsTogether) {
    solveGroups(members, touching, first, std::min(first + kGroupsTogether, count), worker);
  }
}

void GroupedWorld::formGroups(const Neighbourhoods::Members& members, Touching& touching) const {
  touching.touchEnds.clear();
  touching.jointEnds.clear();
  for (const Touch& touch : touching.touches) {
    touching.touchEnds.push_back(neighbourhoods_.placesOf({touch.a, touch.b}));
  }
  for (const std::uint32_t joint : members.joints) {
    touching.jointEnds.push_back(neighbourhoods_.placesOf(ends_[joint]));
  }
  touching.groups.form(members.bodies.size(), touching.touchEnds, touching.jointEnds);
}

GroupedWorld::Solved GroupedWorld::gather(const Neighbourhoods::Members& members, const Touching& touching,
                                          std::size_t group, Scratch& scratch) const {
  auto& [bodies, manifolds, joints] = scratch.gathered;
  Solved solved{group, scratch.gathered.end(), {}, scratch.before.end()};
  scratch.touches.clear();
  for (const std::uint32_t place : touching.groups.bodies(group)) {
    bodies.push_back(bodies_[members.bodies[place]]);
  }
  for (const std::uint32_t place : touching.groups.joints(group)) {
    joints.push_back(joints_[members.joints[place]]);
  }
  for (const std::uint32_t touch : touching.groups.touches(group)) scratch.touches.push_back(touching.touches[touch]);
  std::ranges::sort(scratch.touches, std::less<>());
  const std::size_t count = scratch.pieces.limit(scratch.touches, mostContacts_);
  for (std::size_t i = 0; i < count; ++i) manifolds.push_back(scratch.touches[i].manifold);
  solved.end = scratch.gathered.end();
  return solved;
}

void GroupedWorld::solveGroups(const Neighbourhoods::Members& members, const Touching& touching, std::size_t first,
                               std::size_t end, std::size_t worker) {
  Scratch& scratch = scratches_[worker];
  Gathered& gathered = scratch.gathered;
  gathered.bodies.clear();
  gathered.manifolds.clear();
  gathered.joints.clear();
  scratch.solved.clear();
  scratch.before.clear();
  for (std::size_t group = first; group < end; ++group) {
    prefetchBodies(members, touching, group + 1);
    prepareGroup(members, touching, group, scratch);
    prefetchJoints(members, touching, group + 1);
  }
  for (const Solved& solved : scratch.solved) {
    const auto bodies = gathered.bodiesOf(solved);
    const auto manifolds = gathered.manifoldsOf(solved);
    const auto joints = gathered.jointsOf(solved);
    solvers_[worker]->solveGroup(bodies.data(), static_cast<int>(bodies.size()), manifolds.data(),
                                 static_cast<int>(manifolds.size()), joints.data(), static_cast<int>(joints.size()),
                                 getSolverInfo(), getDebugDrawer(), getDispatcher());
    prefetchSurfaces(members, touching, solved.group + 1);
  }
  for (const Solved& solved : scratch.solved) finishGroup(members, touching, solved, scratch);
}

/// Takes the group among those that are solved, unless it rests.
void GroupedWorld::prepareGroup(const Neighbourhoods::Members& members, const Touching& touching, std::size_t group,
                                Scratch& scratch) {
  const Solved solved = gather(members, touching, group, scratch);
  const auto bodies = scratch.gathered.bodiesOf(solved);
  const auto manifolds = scratch.gathered.manifoldsOf(solved);
  const auto joints = scratch.gathered.jointsOf(solved);
  if (joints.empty() && rest_.isSettled(bodies, manifolds)) {
    for (btCollisionObject* object : bodies) static_cast<btRigidBody&>(*object).clearForces();
    return;
  }
  rest_.begin(bodies, manifolds, !joints.empty(), scratch.before);
  work_.prepare(bodies, joints, getSolverInfo().m_timeStep);
  scratch.solved.push_back(solved);
}

void GroupedWorld::finishGroup(const Neighbourhoods::Members& members, const Touching& touching, const Solved& solved,
                               Scratch& scratch) {
  const auto bodies = scratch.gathered.bodiesOf(solved);
  const auto manifolds = scratch.gathered.manifoldsOf(solved);
  const auto joints = scratch.gathered.jointsOf(solved);
  const double dt = getSolverInfo().m_timeStep;
  for (btCollisionObject* object : bodies) move(static_cast<btRigidBody&>(*object), dt);
  work_.finish(bodies, joints);
  rest_.end(bodies, manifolds, !joints.empty(), scratch.before, solved.before);
  for (const std::uint32_t place : touching.groups.bodies(solved.group)) {
    const std::uint32_t number = members.bodies[place];
    if (!isDamped(*bodies_[number])) boxes_.sweep(*bodies_[number], number, dt);
  }
  for (btCollisionObject* object : bodies) static_cast<btRigidBody&>(*object).clearForces();
}

void GroupedWorld::prefetchBodies(const Neighbourhoods::Members& members, const Touching& touching,
                                  std::size_t group) const {
  if (group >= touching.groups.count()) return;
  for (const std::uint32_t place : touching.groups.bodies(group)) {
    work_.prefetch(std::size_t{members.bodies[place]});
    rest_.prefetch(members.bodies[place]);
  }
}

void GroupedWorld::prefetchJoints(const Neighbourhoods::Members& members, const Touching& touching,
                                  std::size_t group) const {
  if (group >= touching.groups.count()) return;
  for (const std::uint32_t place : touching.groups.joints(group)) work_.prefetch(*joints_[members.joints[place]]);
}

void GroupedWorld::prefetchSurfaces(const Neighbourhoods::Members& members, const Touching& touching,
                                    std::size_t group) const {
  if (group >= touching.groups.count()) return;
  for (const std::uint32_t place : touching.groups.bodies(group)) {
    const std::uint32_t body = members.bodies[place];
    work_.prefetchSurface(body);
    BroadPhase::prefetchLeaf(*bodies_[body]->getBroadphaseProxy());
  }
}

}  // namespace pongsim::physics
