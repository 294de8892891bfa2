#include "physics/solving/grouped_world.hh"

#include <BulletCollision/CollisionShapes/btCollisionShape.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/ConstraintSolver/btConstraintSolver.h>
#include <BulletDynamics/ConstraintSolver/btTypedConstraint.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "base/prefetch.hh"
#include "physics/motion.hh"
#include "physics/solving/rounding.hh"
#include "pongsim/math.hh"

namespace pongsim::physics {

namespace {

// how many a worker takes at a time: one is too little to be worth the asking
constexpr std::size_t kBodiesAtATime = 16;

/// What a step reads and writes of a body stands before that [bytes]; behind it is what Bullet's own solver needs.
constexpr std::size_t kMovingPart = 1024;

/// For how long a body that has left its box gets room in its new one [s], but for no more than its own size.
constexpr double kAhead = 0.1;

// Where it will be after `dt`, for its box only: turned to first order, which makes it larger by half the square of the
// angle.
btTransform roughlyMoved(const btRigidBody& body, double dt) {
  const btTransform& now = body.getWorldTransform();
  const btMatrix3x3& R = now.getBasis();
  const btVector3 turn = body.getAngularVelocity() * dt;
  const btMatrix3x3 turned(R[0] + turn.y() * R[2] - turn.z() * R[1], R[1] + turn.z() * R[0] - turn.x() * R[2],
                           R[2] + turn.x() * R[1] - turn.y() * R[0]);
  return btTransform(turned, now.getOrigin() + body.getLinearVelocity() * dt);
}

/// @return How much of a speed is left after `dt`, of which 1 - `damping` is left after a second.
double leftAfter(double dt, double damping) { return math::exp(dt * math::log1p(-damping)); }

// as btRigidBody::applyDamping, which asks the C library for the power
void damp(btRigidBody& body, double dt) {
  body.setLinearVelocity(body.getLinearVelocity() * leftAfter(dt, body.getLinearDamping()));
  body.setAngularVelocity(body.getAngularVelocity() * leftAfter(dt, body.getAngularDamping()));
}

// what is rounded rests to the bit
void move(btRigidBody& body, double dt) {
  body.setLinearVelocity(roundedVelocity(body.getLinearVelocity()));
  body.setAngularVelocity(roundedVelocity(body.getAngularVelocity()));
  body.proceedToTransform(moved(body.getWorldTransform(), body.getLinearVelocity(), body.getAngularVelocity(), dt));
}

struct Aabb {
  btVector3 lowest;
  btVector3 highest;
};

/// @return What holds the body where it is now and where it is going.
Aabb aabbOf(const btRigidBody& body) {
  Aabb now, then;
  body.getCollisionShape()->getAabb(body.getWorldTransform(), now.lowest, now.highest);
  body.getCollisionShape()->getAabb(body.getInterpolationWorldTransform(), then.lowest, then.highest);
  now.lowest.setMin(then.lowest);
  now.highest.setMax(then.highest);
  const btVector3 margin(gContactBreakingThreshold, gContactBreakingThreshold, gContactBreakingThreshold);
  return {now.lowest - margin, now.highest + margin};
}

btVector3 wayAhead(const btRigidBody& body) {
  const btBroadphaseProxy& proxy = *body.getBroadphaseProxy();
  const btVector3 most = proxy.m_aabbMax - proxy.m_aabbMin;
  btVector3 way = body.getLinearVelocity() * kAhead;
  way.setMax(-most);
  way.setMin(most);
  return way;
}

}  // namespace

GroupedWorld::GroupedWorld(Dispatcher& dispatcher, BroadPhase& broadPhase, btCollisionConfiguration& configuration,
                           std::vector<std::unique_ptr<btConstraintSolver>> solvers, long long mostContacts,
                           base::Workers& workers, Rest& rest, GroupWork& work)
    : btDiscreteDynamicsWorld(&dispatcher, &broadPhase, solvers.front().get(), &configuration),
      solvers_(std::move(solvers)),
      mostContacts_(mostContacts),
      dispatcher_(dispatcher),
      broadPhase_(broadPhase),
      workers_(workers),
      rest_(rest),
      work_(work),
      scratches_(solvers_.size()) {}

void GroupedWorld::setBodies(std::size_t first, std::span<btRigidBody* const> bodies) {
  bodies_.resize(first);
  bodies_.insert(bodies_.end(), bodies.begin(), bodies.end());
  for (std::size_t i = first; i < bodies_.size(); ++i) bodies_[i]->setIslandTag(static_cast<int>(i));
  endsAreOld_ = true;
  rest_.resize(first, bodies_.size());
}

void GroupedWorld::setJoints(std::size_t first, std::span<btTypedConstraint* const> joints) {
  joints_.resize(first);
  joints_.insert(joints_.end(), joints.begin(), joints.end());
  endsAreOld_ = true;
}

// of all joints: any may hold a body that has another number now
void GroupedWorld::findEnds() {
  ends_.clear();
  for (const btTypedConstraint* joint : joints_) {
    ends_.emplace_back(joint->getRigidBodyA().getIslandTag(), joint->getRigidBodyB().getIslandTag());
  }
  endsAreOld_ = false;
}

GroupedWorld::Stay GroupedWorld::stayOf(btRigidBody& body) const {
  // Bullet has its own way with what is as large as that, or not a number
  constexpr double kSanest = 1e12;
  const Aabb aabb = aabbOf(body);
  if (!((aabb.highest - aabb.lowest).length2() < kSanest)) return Stay::kAbsurd;
  return BroadPhase::stay(*body.getBroadphaseProxy(), aabb.lowest, aabb.highest) ? Stay::kYes : Stay::kNo;
}

template <class Work>
void GroupedWorld::forEachBody(Work&& work) {
  workers_.forEach((bodies_.size() + kBodiesAtATime - 1) / kBodiesAtATime, [&](std::size_t chunk, int) {
    const std::size_t end = std::min(bodies_.size(), (chunk + 1) * kBodiesAtATime);
    for (std::size_t i = chunk * kBodiesAtATime; i < end; ++i) work(*bodies_[i], i);
  });
}

// as Bullet's own, but side by side, and with the boxes that it will ask for next
void GroupedWorld::predictUnconstraintMotion(btScalar dt) {
  stays_.resize(bodies_.size());
  forEachBody([&](btRigidBody& body, std::size_t i) {
    prefetchBodies(i);
    if (rest_.keepsAabb(body)) {
      stays_[i] = Stay::kYes;
      return;
    }
    if (body.getLinearDamping() != 0 || body.getAngularDamping() != 0) damp(body, dt);
    body.setInterpolationWorldTransform(roughlyMoved(body, dt));
    stays_[i] = stayOf(body);
  });
  staysAreNew_ = true;
}

void GroupedWorld::updateAabbs() {
  if (!staysAreNew_) {
    stays_.resize(bodies_.size());
    forEachBody([this](btRigidBody& body, std::size_t i) { stays_[i] = stayOf(body); });
  }
  staysAreNew_ = false;
  for (std::size_t i = 0; i < stays_.size(); ++i) {
    if (stays_[i] == Stay::kNo) broadPhase_.leave(*bodies_[i]->getBroadphaseProxy(), wayAhead(*bodies_[i]));
    if (stays_[i] == Stay::kAbsurd) updateSingleAabb(bodies_[i]);
  }
}

void GroupedWorld::solveConstraints(btContactSolverInfo& info) {
  if (endsAreOld_) findEnds();
  groups_.form(bodies_.size(), dispatcher_.touches(), ends_);
  workers_.forEach(groups_.count(),
                   [&](std::size_t group, int worker) { solveGroup(group, static_cast<std::size_t>(worker), info); });
}

void GroupedWorld::gather(std::size_t group, Scratch& scratch) {
  scratch.bodies.clear();
  scratch.manifolds.clear();
  scratch.joints.clear();
  for (const std::uint32_t body : groups_.bodies(group)) scratch.bodies.push_back(bodies_[body]);
  for (const std::uint32_t joint : groups_.joints(group)) scratch.joints.push_back(joints_[joint]);
  const std::span<Touch> touches = groups_.touches(group);
  std::ranges::sort(touches, std::less<>());
  const std::size_t count = scratch.pieces.limit(touches, mostContacts_);
  for (const Touch& touch : touches.first(count)) scratch.manifolds.push_back(touch.manifold);
}

// of those that come soon after `now`, each time what the time before has led to
void GroupedWorld::prefetchBodies(std::size_t now) const {
  constexpr std::size_t kFar = 8, kNear = 5, kNext = 2;
  if (now + kFar < bodies_.size()) {
    base::prefetch(*bodies_[now + kFar], kMovingPart);
    rest_.prefetch(now + kFar);
  }
  if (now + kNear < bodies_.size()) BroadPhase::prefetch(*bodies_[now + kNear]->getBroadphaseProxy());
  if (now + kNext < bodies_.size()) BroadPhase::prefetchLeaf(*bodies_[now + kNext]->getBroadphaseProxy());
}

void GroupedWorld::prefetchBodiesOf(std::size_t group) const {
  if (group >= groups_.count()) return;
  for (const std::uint32_t body : groups_.bodies(group)) {
    work_.prefetch(std::size_t{body});
    rest_.prefetch(body);
  }
}

void GroupedWorld::prefetchHoldsOf(std::size_t group) {
  if (group >= groups_.count()) return;
  for (const std::uint32_t joint : groups_.joints(group)) work_.prefetch(*joints_[joint]);
  // else another worker may be sorting them
  if (workers_.count() > 1) return;
  for (const Touch& touch : groups_.touches(group)) {
    // most have one point; what says how many stands behind all of them
    base::prefetch(touch.manifold->getContactPoint(0));
    base::prefetch(touch.manifold->m_companionIdA);
  }
}

void GroupedWorld::prefetchSurfacesOf(std::size_t group) const {
  if (group >= groups_.count()) return;
  for (const std::uint32_t body : groups_.bodies(group)) work_.prefetchSurface(body);
}

void GroupedWorld::solveGroup(std::size_t group, std::size_t worker, const btContactSolverInfo& info) {
  prefetchBodiesOf(group + 1);
  Scratch& scratch = scratches_[worker];
  gather(group, scratch);
  auto& [bodies, manifolds, joints, pieces, before] = scratch;
  if (!joints.empty() || !rest_.isSettled(bodies, manifolds)) {
    const double dt = info.m_timeStep;
    rest_.begin(bodies, manifolds, !joints.empty(), before);
    work_.prepare(bodies, joints, dt);
    prefetchHoldsOf(group + 1);
    solvers_[worker]->solveGroup(bodies.data(), static_cast<int>(bodies.size()), manifolds.data(),
                                 static_cast<int>(manifolds.size()), joints.data(), static_cast<int>(joints.size()),
                                 info, getDebugDrawer(), getDispatcher());
    prefetchSurfacesOf(group + 1);
    for (btCollisionObject* object : bodies) move(static_cast<btRigidBody&>(*object), dt);
    work_.finish(bodies, joints);
    rest_.end(bodies, manifolds, !joints.empty(), before);
  }
  for (btCollisionObject* object : bodies) static_cast<btRigidBody&>(*object).clearForces();
}

}  // namespace pongsim::physics
