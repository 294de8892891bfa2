#include "physics/grouped_world.hh"

#include <BulletCollision/BroadphaseCollision/btDispatcher.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/ConstraintSolver/btConstraintSolver.h>
#include <BulletDynamics/ConstraintSolver/btTypedConstraint.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include "physics/dispatcher.hh"
#include "physics/motion.hh"
#include "physics/rounding.hh"
#include "pongsim/math.hh"

namespace pongsim::physics {

namespace {

// how many a worker takes at a time: one is too little to be worth the asking
constexpr std::size_t kBodiesAtATime = 16;

// of bodies that forces do not move; for others it is the place in the array
constexpr int kNoMember = -1;

int memberOf(const btCollisionObject& object) { return object.getIslandTag(); }

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

template <class T>
T* dataOf(std::vector<T>& array, std::size_t first) {
  return array.empty() ? nullptr : array.data() + first;
}

}  // namespace

GroupedWorld::GroupedWorld(btDispatcher& dispatcher, btBroadphaseInterface& broadphase,
                           btCollisionConfiguration& configuration,
                           std::vector<std::unique_ptr<btConstraintSolver>> solvers, base::Workers& workers, Rest& rest,
                           GroupWork& work)
    : btDiscreteDynamicsWorld(&dispatcher, &broadphase, solvers.front().get(), &configuration),
      solvers_(std::move(solvers)),
      workers_(workers),
      rest_(rest),
      before_(solvers_.size()),
      work_(work) {}

void GroupedWorld::setBodies(std::size_t first, std::span<btRigidBody* const> bodies) {
  bodies_.resize(first);
  bodies_.insert(bodies_.end(), bodies.begin(), bodies.end());
  for (std::size_t i = first; i < bodies_.size(); ++i) bodies_[i]->setIslandTag(static_cast<int>(i));
  rest_.resize(first, bodies_.size());
}

void GroupedWorld::setJoints(std::size_t first, std::span<btTypedConstraint* const> joints) {
  joints_.resize(first);
  joints_.insert(joints_.end(), joints.begin(), joints.end());
}

GroupedWorld::Aabb GroupedWorld::aabbOf(const btRigidBody& body) {
  Aabb now;
  body.getCollisionShape()->getAabb(body.getWorldTransform(), now.lowest, now.highest);
  Aabb then;
  body.getCollisionShape()->getAabb(body.getInterpolationWorldTransform(), then.lowest, then.highest);
  now.lowest.setMin(then.lowest);
  now.highest.setMax(then.highest);
  const btVector3 margin(gContactBreakingThreshold, gContactBreakingThreshold, gContactBreakingThreshold);
  return {now.lowest - margin, now.highest + margin, false};
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
  aabbs_.resize(bodies_.size());
  forEachBody([&](btRigidBody& body, std::size_t i) {
    aabbs_[i].isKept = rest_.keepsAabb(body);
    if (aabbs_[i].isKept) return;
    if (body.getLinearDamping() != 0 || body.getAngularDamping() != 0) damp(body, dt);
    body.setInterpolationWorldTransform(roughlyMoved(body, dt));
    aabbs_[i] = aabbOf(body);
  });
  aabbsAreNew_ = true;
}

// what is put somewhere is there at once; Bullet makes a speed of the rounding of its turn
void GroupedWorld::saveKinematicState(btScalar /*dt*/) {
  const btCollisionObjectArray& objects = getCollisionObjectArray();
  for (int i = 0; i < objects.size(); ++i) {
    if (!objects[i]->isKinematicObject()) continue;
    btRigidBody& body = static_cast<btRigidBody&>(*objects[i]);
    body.setLinearVelocity(btVector3(0, 0, 0));
    body.setAngularVelocity(btVector3(0, 0, 0));
  }
}

void GroupedWorld::updateAabbs() {
  if (!aabbsAreNew_) {
    aabbs_.resize(bodies_.size());
    forEachBody([this](btRigidBody& body, std::size_t i) { aabbs_[i] = aabbOf(body); });
  }
  aabbsAreNew_ = false;
  const btCollisionObjectArray& objects = getCollisionObjectArray();
  for (int i = 0; i < objects.size(); ++i) {
    btCollisionObject& object = *objects[i];
    if (!object.isActive()) continue;
    const int member = memberOf(object);
    const Aabb* const aabb = member == kNoMember ? nullptr : &aabbs_[static_cast<std::size_t>(member)];
    if (aabb != nullptr && aabb->isKept) continue;
    // Bullet has its own way with what is as large as that, or not a number
    constexpr double kSanest = 1e12;
    if (aabb != nullptr && (aabb->highest - aabb->lowest).length2() < kSanest) {
      getBroadphase()->setAabb(object.getBroadphaseHandle(), aabb->lowest, aabb->highest, getDispatcher());
    } else {
      updateSingleAabb(&object);
    }
  }
}

void GroupedWorld::solveConstraints(btContactSolverInfo& info) {
  collectTouches();
  uniteBodies();
  countMembers();
  sortByGroup();
  workers_.forEach(groups_.size() - 1,
                   [&](std::size_t group, int worker) { solveGroup(group, static_cast<std::size_t>(worker), info); });
}

void GroupedWorld::solveGroup(std::size_t group, std::size_t worker, const btContactSolverInfo& info) {
  const Group& first = groups_[group];
  const Group& end = groups_[group + 1];
  const std::span bodies(dataOf(bodiesByGroup_, first.bodies), end.bodies - first.bodies);
  const std::span manifolds(dataOf(manifoldsByGroup_, first.manifolds), end.manifolds - first.manifolds);
  const std::span joints(dataOf(jointsByGroup_, first.joints), end.joints - first.joints);
  if (joints.empty() && rest_.isSettled(bodies, manifolds)) return;
  const double dt = info.m_timeStep;
  rest_.begin(bodies, manifolds, before_[worker]);
  work_.prepare(bodies, joints, dt);
  solvers_[worker]->solveGroup(bodies.data(), static_cast<int>(bodies.size()), manifolds.data(),
                               static_cast<int>(manifolds.size()), joints.data(), static_cast<int>(joints.size()), info,
                               getDebugDrawer(), getDispatcher());
  for (btCollisionObject* object : bodies) move(static_cast<btRigidBody&>(*object), dt);
  work_.finish(bodies, joints);
  rest_.end(bodies, manifolds, !joints.empty(), before_[worker]);
}

void GroupedWorld::collectTouches() {
  touches_.clear();
  btDispatcher& dispatcher = *getDispatcher();
  for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
    btPersistentManifold* manifold = dispatcher.getManifoldByIndexInternal(i);
    if (manifold->getNumContacts() == 0) continue;
    limitContacts(*manifold);
    if (manifold->getNumContacts() == 0) continue;
    const btCollisionObject& a = *manifold->getBody0();
    const btCollisionObject& b = *manifold->getBody1();
    if (memberOf(a) == kNoMember && memberOf(b) == kNoMember) continue;
    auto slotA = static_cast<std::uint32_t>(a.getUserIndex());
    auto slotB = static_cast<std::uint32_t>(b.getUserIndex());
    auto partA = static_cast<std::uint32_t>(manifold->m_companionIdA);
    auto partB = static_cast<std::uint32_t>(manifold->m_companionIdB);
    if (slotB < slotA) {
      std::swap(slotA, slotB);
      std::swap(partA, partB);
    }
    touches_.push_back({std::uint64_t{slotA} << 32U | slotB, std::uint64_t{partA} << 32U | partB, manifold});
  }
  std::ranges::sort(
      touches_, [](const Touch& a, const Touch& b) { return std::tie(a.links, a.parts) < std::tie(b.links, b.parts); });
  limitContactsOfPieces();
}

// The limit is one of two collisions, which may touch with many of their pieces. The deepest point stays, and then
// always the one that is farthest from those that stay: they shall bear the body.
void GroupedWorld::limitContactsOfPieces() {
  constexpr std::uint64_t kWhole = 0xffffffffU;
  const auto collisionsOf = [](const Touch& touch) {
    const auto collision = [](std::uint64_t part) {
      return static_cast<std::uint32_t>(part) == kWhole
                 ? static_cast<std::uint32_t>(kWhole)
                 : static_cast<std::uint32_t>(collisionOfPart(static_cast<int>(static_cast<std::uint32_t>(part))));
    };
    return std::tuple(touch.links, collision(touch.parts >> 32U), collision(touch.parts));
  };
  bool isOneEmpty = false;
  for (auto first = touches_.begin(); first != touches_.end();) {
    const auto pair = collisionsOf(*first);
    const auto end = std::find_if(first + 1, touches_.end(), [&](const Touch& t) { return collisionsOf(t) != pair; });
    const long long most = end - first > 1 ? work_.mostContacts(*first->manifold) : -1;
    if (most >= 0) isOneEmpty |= keepSpread(std::span(first, end), static_cast<std::size_t>(most));
    first = end;
  }
  if (isOneEmpty) std::erase_if(touches_, [](const Touch& touch) { return touch.manifold->getNumContacts() == 0; });
}

bool GroupedWorld::keepSpread(std::span<const Touch> touches, std::size_t most) {
  points_.clear();
  for (const Touch& touch : touches) {
    for (int i = 0; i < touch.manifold->getNumContacts(); ++i) {
      points_.push_back({touch.manifold, i, std::numeric_limits<double>::infinity(), false});
    }
  }
  if (points_.size() <= most) return false;
  const auto pointOf = [](const Point& point) -> const btManifoldPoint& {
    return point.manifold->getContactPoint(point.index);
  };
  auto next = std::ranges::min_element(points_, {}, [&](const Point& p) { return pointOf(p).getDistance(); });
  for (std::size_t kept = 0; kept < most; ++kept) {
    next->isKept = true;
    const btVector3 place = pointOf(*next).getPositionWorldOnB();
    for (Point& point : points_) {
      const double distance = (pointOf(point).getPositionWorldOnB() - place).length2();
      point.distance = point.isKept ? -1 : std::min(point.distance, distance);
    }
    next = std::ranges::max_element(points_, {}, &Point::distance);
  }
  // from behind, for the last one of a manifold takes the place of one that goes
  bool isOneEmpty = false;
  for (auto point = points_.rbegin(); point != points_.rend(); ++point) {
    if (!point->isKept) point->manifold->removeContactPoint(point->index);
    isOneEmpty |= point->manifold->getNumContacts() == 0;
  }
  return isOneEmpty;
}

// the deepest ones stay
void GroupedWorld::limitContacts(btPersistentManifold& manifold) const {
  const long long most = work_.mostContacts(manifold);
  while (most >= 0 && manifold.getNumContacts() > most) {
    int shallowest = 0;
    for (int i = 1; i < manifold.getNumContacts(); ++i) {
      if (manifold.getContactPoint(i).getDistance() > manifold.getContactPoint(shallowest).getDistance())
        shallowest = i;
    }
    manifold.removeContactPoint(shallowest);
  }
}

std::size_t GroupedWorld::rootOf(std::size_t body) {
  while (parents_[body] != body) {
    parents_[body] = parents_[parents_[body]];
    body = parents_[body];
  }
  return body;
}

void GroupedWorld::unite(const btCollisionObject& a, const btCollisionObject& b) {
  if (memberOf(a) == kNoMember || memberOf(b) == kNoMember) return;
  const std::size_t rootA = rootOf(static_cast<std::size_t>(memberOf(a)));
  const std::size_t rootB = rootOf(static_cast<std::size_t>(memberOf(b)));
  parents_[std::max(rootA, rootB)] = std::min(rootA, rootB);
}

std::size_t GroupedWorld::groupOf(const btCollisionObject& a, const btCollisionObject& b) const {
  return groupOfBody_[static_cast<std::size_t>(memberOf(a) != kNoMember ? memberOf(a) : memberOf(b))];
}

std::size_t GroupedWorld::groupOf(const btPersistentManifold& manifold) const {
  return groupOf(*manifold.getBody0(), *manifold.getBody1());
}

std::size_t GroupedWorld::groupOf(const btTypedConstraint& joint) const {
  return groupOf(joint.getRigidBodyA(), joint.getRigidBodyB());
}

void GroupedWorld::uniteBodies() {
  parents_.resize(bodies_.size());
  for (std::size_t i = 0; i < parents_.size(); ++i) parents_[i] = i;
  for (const Touch& touch : touches_) unite(*touch.manifold->getBody0(), *touch.manifold->getBody1());
  for (const btTypedConstraint* joint : joints_) unite(joint->getRigidBodyA(), joint->getRigidBodyB());
}

void GroupedWorld::countMembers() {
  // a root stands before the others of its group
  groups_.clear();
  groupOfBody_.resize(bodies_.size());
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const std::size_t root = rootOf(i);
    if (root == i) groups_.emplace_back();
    groupOfBody_[i] = root == i ? groups_.size() - 1 : groupOfBody_[root];
    ++groups_[groupOfBody_[i]].bodies;
  }
  for (const Touch& touch : touches_) ++groups_[groupOf(*touch.manifold)].manifolds;
  for (const btTypedConstraint* joint : joints_) ++groups_[groupOf(*joint)].joints;

  // from how many to where they begin
  Group sum;
  groups_.emplace_back();
  for (Group& group : groups_) {
    const Group count = std::exchange(group, sum);
    sum = {sum.bodies + count.bodies, sum.manifolds + count.manifolds, sum.joints + count.joints};
  }
}

void GroupedWorld::sortByGroup() {
  next_ = groups_;
  bodiesByGroup_.resize(bodies_.size());
  manifoldsByGroup_.resize(touches_.size());
  jointsByGroup_.resize(joints_.size());
  for (std::size_t i = 0; i < bodies_.size(); ++i) bodiesByGroup_[next_[groupOfBody_[i]].bodies++] = bodies_[i];
  for (const Touch& touch : touches_) {
    manifoldsByGroup_[next_[groupOf(*touch.manifold)].manifolds++] = touch.manifold;
  }
  for (btTypedConstraint* joint : joints_) jointsByGroup_[next_[groupOf(*joint)].joints++] = joint;
}

}  // namespace pongsim::physics
