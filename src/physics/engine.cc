#include "physics/engine.hh"

#include <BulletDynamics/ConstraintSolver/btConstraintSolver.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <iterator>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/arena.hh"
#include "base/prefetch.hh"
#include "physics/body.hh"
#include "physics/contacts/collision_configuration.hh"
#include "physics/contacts/contact_filter.hh"
#include "physics/contacts/contact_list.hh"
#include "physics/contacts/manifold_state.hh"
#include "physics/contacts/surface.hh"
#include "physics/convert.hh"
#include "physics/dynamics_world.hh"
#include "physics/gearbox.hh"
#include "physics/joint.hh"
#include "physics/solving/friction_frames.hh"

namespace pongsim::physics {

struct Engine::Parts final : GroupWork {
  Parts(const world::Entities& entitiesOfWorld, const Settings& settingsOfWorld, HullStore& hullsOfWorld,
        CollisionConfiguration& configuration, base::Arena& arenaOfWorld, std::shared_ptr<btRigidBody> fixed)
      : entities(entitiesOfWorld),
        settings(settingsOfWorld),
        hulls(hullsOfWorld),
        arena(arenaOfWorld),
        gravity(entities.description().gravity),
        filter(entities),
        world(settings, configuration, arena, *this),
        anchor(std::move(fixed)) {
    world.bullet().getPairCache()->setOverlapFilterCallback(&filter);
    grow();
  }
  ~Parts() override;

  void prepare(std::span<btCollisionObject* const> groupBodies, std::span<btTypedConstraint* const> groupJoints,
               double seconds) override;
  void finish(std::span<btCollisionObject* const> groupBodies,
              std::span<btTypedConstraint* const> groupJoints) override;
  void prefetch(std::size_t member) const override { base::prefetch(*moving[member]); }
  void prefetchSurface(std::size_t member) const override { moving[member]->shape().prefetch(); }
  // what it is stands in it; one of a gearbox's parts is smaller
  void prefetch(const btTypedConstraint& joint) const override { base::prefetch(joint, sizeof(Joint)); }

  void grow();
  void prepareHulls();
  void addJoints();
  void remove(const world::Removal& removal);
  /// Takes the bodies of these links out of the world.
  void takeOut(const std::vector<world::Slot>& links);
  /// Tells bodies and joints of their slots, and the world of who moves.
  void renumber();
  /// As `renumber`, where nothing before these has changed.
  void renumberFrom(world::Slot firstLink, world::Slot firstJoint);
  void take(Body& body);
  JointEnd end(world::Slot link, const Pose& X_LinkJoint);
  bool hasAxis(world::Slot joint, std::size_t axis) const {
    return joint < joints.size() && axis < joints[joint]->axisCount();
  }
  Joint& jointWithAxis(world::Slot slot, std::size_t axis);
  Body& bodyOf(const btCollisionObject& object) { return *bodies[static_cast<world::Slot>(object.getUserIndex())]; }
  [[noreturn]] void reportExplosion(world::Slot link) const;

  const world::Entities& entities;
  const Settings settings;
  HullStore& hulls;
  base::Arena& arena;
  SharedShapes shared;
  Vector3 gravity;
  ContactFilter filter;
  DynamicsWorld world;
  /// What joints to the world hold on to; those that are set aside, too, while all else is made anew.
  const std::shared_ptr<btRigidBody> anchor;
  /// One a link, in the order of their slots.
  std::vector<base::Arena::Pointer<Body>> bodies;
  std::vector<Body*> moving;
  /// One a joint, in the order of their slots.
  std::vector<base::Arena::Pointer<Joint>> joints;
  /// For each joint, how many constraints the world has of those up to it.
  std::vector<std::size_t> holdingEnd;
  FrictionFrames frictionFrames;
  /// Length of the last step [s].
  double dt = 1;

  /// What the step writes to.
  world::State* state = nullptr;
  /// The first link whose motion has exploded, else `world::kNoSlot`.
  std::atomic<world::Slot> exploded = world::kNoSlot;
  /// The first link that was slowed down in this step, likewise.
  std::atomic<world::Slot> slowedDown = world::kNoSlot;
};

/// One of two parts that touched, or both, are set aside.
struct KeptTouch {
  LinkId linkA;
  LinkId linkB;
  ManifoldPoints points;
};

struct SetAside::Content {
  std::shared_ptr<base::Arena> arena;
  std::shared_ptr<btRigidBody> anchor;
  std::vector<base::Arena::Pointer<Body>> bodies;
  // behind the bodies, on which they hold
  std::vector<base::Arena::Pointer<Joint>> joints;
  std::vector<KeptTouch> touches;
};

namespace {

std::shared_ptr<btRigidBody> makeAnchor() {
  return std::make_shared<btRigidBody>(btRigidBody::btRigidBodyConstructionInfo(0, nullptr, nullptr));
}

void keepFirst(std::atomic<world::Slot>& first, world::Slot link) {
  world::Slot before = first;
  while (link < before && !first.compare_exchange_weak(before, link)) {
  }
}

}  // namespace

Engine::Parts::~Parts() { world.bullet().clear(); }

void Engine::Parts::prepare(std::span<btCollisionObject* const> groupBodies,
                            std::span<btTypedConstraint* const> groupJoints, double seconds) {
  for (btTypedConstraint* joint : groupJoints) {
    if (!isGearReference(*joint)) static_cast<Joint*>(joint)->prepare(seconds);
  }
  for (btCollisionObject* object : groupBodies) bodyOf(*object).addForces(seconds, !groupJoints.empty());
}

void Engine::Parts::finish(std::span<btCollisionObject* const> groupBodies,
                           std::span<btTypedConstraint* const> groupJoints) {
  for (btCollisionObject* object : groupBodies) {
    Body& body = bodyOf(*object);
    if (body.slowDown(dt)) keepFirst(slowedDown, body.link());
    if (!body.read(state->links[body.link()])) keepFirst(exploded, body.link());
  }
  for (btTypedConstraint* constraint : groupJoints) {
    if (isGearReference(*constraint)) continue;
    Joint& joint = static_cast<Joint&>(*constraint);
    joint.update();
    state->joints[joint.slot()] = joint.state();
  }
}

void Engine::Parts::grow() {
  prepareHulls();
  const world::Slot firstLink = bodies.size(), firstJoint = joints.size();
  std::vector<base::Arena::Pointer<Body>> newBodies;
  for (world::Slot link = bodies.size(); link < entities.links().size(); ++link) {
    newBodies.push_back(arena.make<Body>(entities, link, gravity, hulls, shared));
  }
  // before a body comes: who may touch it is asked then
  filter.grow();
  for (auto& body : newBodies) {
    take(*body);
    bodies.push_back(std::move(body));
  }
  addJoints();
  renumberFrom(firstLink, firstJoint);
  frictionFrames.find(bodies, firstLink, entities);
}

void Engine::Parts::take(Body& body) {
  if (body.moves() || body.collides()) world.add(body.rigid(), body.id().value);
}

// those of all new links at once, which are worked out side by side
void Engine::Parts::prepareHulls() {
  std::vector<HullRequest> requests;
  for (world::Slot link = bodies.size(); link < entities.links().size(); ++link) {
    const world::LinkRecord& record = entities.links()[link];
    for (const description::Collision& collision : record.description->collisions) {
      if (usesHulls(collision.geometry, isMoving(record))) requests.push_back(requestFor(collision.geometry));
    }
  }
  hulls.prepare(requests);
}

void Engine::Parts::addJoints() {
  for (world::Slot slot = joints.size(); slot < entities.joints().size(); ++slot) {
    const world::JointRecord& record = entities.joints()[slot];
    const description::Joint& description = *record.description;
    joints.push_back(arena.make<Joint>(description, end(record.parentLink, description.X_ParentJoint),
                                       end(record.childLink, description.X_ChildJoint),
                                       end(record.referenceLink, description.X_ReferenceJoint)));
    world.separate(joints.back()->getRigidBodyA(), joints.back()->getRigidBodyB());
  }
}

void Engine::Parts::remove(const world::Removal& removal) {
  std::vector<btRigidBody*> freed;
  for (const world::Slot slot : removal.joints) {
    freed.push_back(&joints[slot]->getRigidBodyA());
    freed.push_back(&joints[slot]->getRigidBodyB());
  }
  takeOut(removal.links);
  frictionFrames.remove(removal.links);
  world::eraseSlots(joints, removal.joints);
  // a body that has gone has no place in the broad phase any more, and must live until that has been looked at
  std::vector<base::Arena::Pointer<Body>> gone;
  for (const world::Slot slot : removal.links) gone.push_back(std::move(bodies[slot]));
  world::eraseSlots(bodies, removal.links);
  renumberFrom(removal.links.empty() ? bodies.size() : removal.links.front(),
               removal.joints.empty() ? joints.size() : removal.joints.front());
  filter.update();
  std::erase_if(freed, [](const btRigidBody* body) { return body->getBroadphaseHandle() == nullptr; });
  std::ranges::sort(freed, {}, [this](const btRigidBody* body) { return bodyOf(*body).link(); });
  const auto repeated = std::ranges::unique(freed);
  freed.erase(repeated.begin(), repeated.end());
  for (btRigidBody* body : freed) world.findPairsOf(*body);
}

void Engine::Parts::takeOut(const std::vector<world::Slot>& links) {
  std::vector<btRigidBody*> present;
  for (const world::Slot link : links) {
    btRigidBody& rigid = bodies[link]->rigid();
    if (rigid.getBroadphaseHandle() != nullptr) present.push_back(&rigid);
  }
  world.bullet().remove(present);
}

void Engine::Parts::renumber() {
  renumberFrom(0, 0);
  frictionFrames.clear();
  frictionFrames.find(bodies, 0, entities);
}

void Engine::Parts::renumberFrom(world::Slot firstLink, world::Slot firstJoint) {
  // those that have gone know their old slots still
  const auto kept = std::ranges::lower_bound(moving, firstLink, {}, &Body::link);
  const auto firstMember = static_cast<std::size_t>(kept - moving.begin());
  moving.erase(kept, moving.end());
  std::vector<btRigidBody*> members;
  for (world::Slot link = firstLink; link < bodies.size(); ++link) {
    bodies[link]->setLink(link);
    if (!bodies[link]->moves()) continue;
    moving.push_back(bodies[link].get());
    members.push_back(&bodies[link]->rigid());
  }
  world.bullet().setBodies(firstMember, members);

  for (world::Slot slot = firstJoint; slot < joints.size(); ++slot) joints[slot]->setSlot(slot);
  const std::size_t firstHolding = firstJoint == 0 ? 0 : holdingEnd[firstJoint - 1];
  holdingEnd.resize(firstJoint);
  std::vector<btTypedConstraint*> holding;
  for (world::Slot slot = firstJoint; slot < joints.size(); ++slot) {
    if (joints[slot]->holdsSomething()) {
      holding.push_back(joints[slot].get());
      if (btTypedConstraint* reference = joints[slot]->reference()) holding.push_back(reference);
    }
    holdingEnd.push_back(firstHolding + holding.size());
  }
  world.bullet().setJoints(firstHolding, holding);
}

JointEnd Engine::Parts::end(world::Slot link, const Pose& X_LinkJoint) {
  if (link == world::kNoSlot) return {anchor.get(), toBullet(X_LinkJoint), false};
  Body& body = *bodies[link];
  return {&body.rigid(), toBullet(body.X_LinkBody().inverse() * X_LinkJoint), body.moves()};
}

Joint& Engine::Parts::jointWithAxis(world::Slot slot, std::size_t axis) {
  // who commands one commands those of the next robots soon
  constexpr world::Slot kAhead = 6;
  if (slot + kAhead < joints.size()) joints[slot + kAhead]->prefetchAxis();
  if (!hasAxis(slot, axis)) throw std::invalid_argument("the joint has no such axis");
  return *joints[slot];
}

void Engine::Parts::reportExplosion(world::Slot link) const {
  const world::LinkRecord& record = entities.links()[link];
  throw std::runtime_error("the motion of link '" + entities.models()[record.model].scopedName +
                           "::" + record.description->name + "' is no longer finite");
}

Engine::Engine(const world::Entities& entities, const Settings& settings)
    : hulls_(std::make_unique<HullStore>(settings.hullCache)),
      configuration_(std::make_unique<CollisionConfiguration>()),
      arena_(std::make_shared<base::Arena>()),
      parts_(std::make_unique<Parts>(entities, settings, *hulls_, *configuration_, *arena_, makeAnchor())) {
  combineSurfacesAsFortress();
}

Engine::~Engine() = default;

bool Engine::hasAxis(world::Slot joint, std::size_t axis) const { return parts_->hasAxis(joint, axis); }

void Engine::setJointVelocityTarget(world::Slot joint, double velocity, std::size_t axis) {
  parts_->jointWithAxis(joint, axis).setVelocityTarget(velocity, axis);
}

void Engine::clearJointVelocityTarget(world::Slot joint, std::size_t axis) {
  parts_->jointWithAxis(joint, axis).clearVelocityTarget(axis);
}

void Engine::addJointForce(world::Slot joint, double force, std::size_t axis) {
  parts_->jointWithAxis(joint, axis).addForce(force, axis);
}

void Engine::setJointPosition(world::Slot joint, double position, std::size_t axis) {
  parts_->jointWithAxis(joint, axis).setPosition(position, axis);
}

void Engine::addLinkWrench(world::Slot link, const Vector3& force, const Vector3& torque) {
  parts_->bodies[link]->addWrench(force, torque);
}

bool Engine::setLinkVelocity(world::Slot link, const Vector3& linear, const Vector3& angular) {
  if (!parts_->bodies[link]->moves()) return false;
  parts_->bodies[link]->setVelocity(linear, angular);
  parts_->world.bullet().forgetBox(parts_->bodies[link]->rigid());
  return true;
}

Engine::Reaction Engine::jointReaction(world::Slot joint) {
  Reaction reaction;
  parts_->joints[joint]->readReaction(reaction.force, reaction.torque);
  return reaction;
}

void Engine::contacts(std::vector<Contact>& contacts) const {
  listContacts(*parts_->world.bullet().getDispatcher(), parts_->entities, parts_->dt, contacts);
}

void Engine::grow() { parts_->grow(); }

void Engine::remove(const world::Removal& removal) { parts_->remove(removal); }

void Engine::reset() {
  // by and by: two of them take twice the memory
  const world::Entities& entities = parts_->entities;
  const Settings settings = parts_->settings;
  std::shared_ptr<btRigidBody> anchor = parts_->anchor;
  parts_.reset();
  parts_ = std::make_unique<Parts>(entities, settings, *hulls_, *configuration_, *arena_, std::move(anchor));
}

void Engine::setGravity(const Vector3& gravity) {
  parts_->world.forgetRest();
  parts_->gravity = gravity;
  for (Body* body : parts_->moving) body->setGravity(gravity);
}

void Engine::setLinkPose(world::Slot link, const Pose& X_WorldLink) {
  Body& body = *parts_->bodies[link];
  body.setPose(X_WorldLink);
  parts_->world.moved(body.rigid());
  parts_->world.forgetRest();
}

void Engine::transfer(StateArchive& archive) {
  if (archive.isGiving()) reset();
  archive(parts_->dt);
  for (const auto& body : parts_->bodies) body->transfer(archive);
  for (const auto& joint : parts_->joints) joint->transfer(archive);
  if (archive.isGiving()) {
    for (const auto& body : parts_->bodies) parts_->world.moved(body->rigid());
  }
  parts_->world.transferContacts(archive);
}

void Engine::step(Time dt, world::State& state) {
  parts_->dt = toSeconds(dt);
  if (std::exchange(parts_->state, &state) != &state || !parts_->frictionFrames.empty()) parts_->world.forgetRest();
  parts_->slowedDown = world::kNoSlot;
  parts_->frictionFrames.turn();
  parts_->world.step(parts_->dt);
  const world::Slot exploded = parts_->exploded.exchange(world::kNoSlot);
  if (exploded != world::kNoSlot) parts_->reportExplosion(exploded);
}

void Engine::setSurfaceMotion(world::Slot link, std::size_t collision, const std::optional<SurfaceMotion>& motion) {
  parts_->world.forgetRest();
  Body& body = *parts_->bodies[link];
  std::optional<SurfaceMotion>& own = body.shape().part(collision).motion;
  own = motion;
  if (own) own->axis = body.X_LinkBody().rotation.conjugate() * own->axis.normalized();
}

std::optional<SurfaceMotion> Engine::surfaceMotion(world::Slot link, std::size_t collision) const {
  const Body& body = *parts_->bodies[link];
  std::optional<SurfaceMotion> motion = body.shape().part(collision).motion;
  if (motion) motion->axis = body.X_LinkBody().rotation * motion->axis;
  return motion;
}

void Engine::setSlip(world::Slot link, std::size_t collision, double slip1, double slip2) {
  LinkShape::Part& part = parts_->bodies[link]->shape().part(collision);
  if (part.slip1 != slip1 || part.slip2 != slip2) parts_->world.forgetRest();
  part.slip1 = slip1;
  part.slip2 = slip2;
}

std::pair<double, double> Engine::slip(world::Slot link, std::size_t collision) const {
  const LinkShape::Part& part = parts_->bodies[link]->shape().part(collision);
  return {part.slip1, part.slip2};
}

world::Slot Engine::slowedDown() const { return parts_->slowedDown; }

bool Engine::isJointDriven(world::Slot joint) const { return parts_->joints[joint]->isDriven(); }

void Engine::releaseJoint(world::Slot joint) { parts_->joints[joint]->release(); }

std::vector<SetAside> Engine::setAside(const world::GroupSlots& groups) {
  Parts& parts = *parts_;
  std::vector<SetAside> result(groups.links.size());
  std::vector<std::size_t> groupOf(parts.bodies.size(), result.size());
  for (std::size_t group = 0; group < result.size(); ++group) {
    result[group].content_ = std::make_unique<SetAside::Content>();
    result[group].content_->arena = arena_;
    result[group].content_->anchor = parts.anchor;
    for (const world::Slot link : groups.links[group]) groupOf[link] = group;
  }
  for (const ManifoldPoints& points : listManifolds(parts.world.dispatcher())) {
    const auto a = static_cast<world::Slot>(points.linkA), b = static_cast<world::Slot>(points.linkB);
    for (const std::size_t group : {groupOf[a], groupOf[b] == groupOf[a] ? result.size() : groupOf[b]}) {
      if (group == result.size()) continue;
      result[group].content_->touches.push_back({parts.bodies[a]->id(), parts.bodies[b]->id(), points});
    }
  }
  std::vector<world::Slot> going;
  for (world::Slot link = 0; link < parts.bodies.size(); ++link) {
    if (groupOf[link] != result.size()) going.push_back(link);
  }
  parts.takeOut(going);
  auto bodies = world::takeSlots(parts.bodies, groups.links);
  auto joints = world::takeSlots(parts.joints, groups.joints);
  for (std::size_t group = 0; group < result.size(); ++group) {
    result[group].content_->bodies = std::move(bodies[group]);
    result[group].content_->joints = std::move(joints[group]);
  }
  parts.renumber();
  parts.filter.update();
  return result;
}

void Engine::bringBack(const world::GroupSlots& groups, std::vector<SetAside> parts) {
  std::vector<std::vector<base::Arena::Pointer<Body>>> bodies;
  std::vector<std::vector<base::Arena::Pointer<Joint>>> joints;
  std::vector<KeptTouch> touches;
  for (SetAside& part : parts) {
    bodies.push_back(std::move(part.content_->bodies));
    joints.push_back(std::move(part.content_->joints));
    std::ranges::move(part.content_->touches, std::back_inserter(touches));
  }
  world::giveSlots(parts_->bodies, groups.links, bodies);
  world::giveSlots(parts_->joints, groups.joints, joints);
  // before a body comes: who may touch it is asked then
  for (world::Slot link = 0; link < parts_->bodies.size(); ++link) parts_->bodies[link]->setLink(link);
  parts_->filter.update();
  std::vector<ManifoldPoints> all = listManifolds(parts_->world.dispatcher());
  for (const std::vector<world::Slot>& group : groups.links) {
    for (const world::Slot link : group) {
      parts_->bodies[link]->setGravity(parts_->gravity);
      parts_->take(*parts_->bodies[link]);
    }
  }
  parts_->renumber();
  for (KeptTouch& touch : touches) {
    const world::Slot a = parts_->entities.slot(touch.linkA), b = parts_->entities.slot(touch.linkB);
    if (a == world::kNoSlot || b == world::kNoSlot) continue;
    touch.points.linkA = static_cast<int>(a);
    touch.points.linkB = static_cast<int>(b);
    all.push_back(std::move(touch.points));
  }
  parts_->world.findTouches();
  restoreManifolds(all, parts_->world.dispatcher());
}

SetAside::SetAside() = default;
SetAside::~SetAside() = default;
SetAside::SetAside(SetAside&&) noexcept = default;
SetAside& SetAside::operator=(SetAside&&) noexcept = default;

void SetAside::transfer(StateArchive& archive, std::span<const LinkId> links) {
  for (const auto& body : content_->bodies) body->transfer(archive);
  for (const auto& joint : content_->joints) joint->transfer(archive);
  std::size_t count = content_->touches.size();
  archive(count);
  if (archive.isGiving()) content_->touches.resize(std::min(count, archive.rest().size()));
  for (KeptTouch& touch : content_->touches) {
    // ids may be others in another run
    for (LinkId* id : {&touch.linkA, &touch.linkB}) {
      auto number = static_cast<std::uint64_t>(std::ranges::lower_bound(links, *id) - links.begin());
      archive(number);
      if (archive.isGiving()) *id = number < links.size() ? links[number] : LinkId();
    }
    archive(touch.points);
  }
}

}  // namespace pongsim::physics
