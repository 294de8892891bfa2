#include "physics/engine.hh"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <iterator>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/arena.hh"
#include "description/limits.hh"
#include "physics/body.hh"
#include "physics/contacts/contact_filter.hh"
#include "physics/contacts/contact_list.hh"
#include "physics/contacts/friction_frames.hh"
#include "physics/contacts/manifold_state.hh"
#include "physics/contacts/surface.hh"
#include "physics/convert.hh"
#include "physics/joint.hh"
#include "physics/stepper.hh"

namespace pongsim::physics {

struct Engine::Parts {
  Parts(const world::Entities& entitiesOfWorld, const Settings& settingsOfWorld, HullStore& hullsOfWorld,
        CollisionConfiguration& configuration, base::Arena& arenaOfWorld)
      : entities(entitiesOfWorld),
        settings(settingsOfWorld),
        hulls(hullsOfWorld),
        arena(arenaOfWorld),
        gravity(entities.description().gravity),
        filter(entities),
        stepper(settings, configuration, arena) {
    stepper.collisions().setFilter(filter);
    grow();
  }
  ~Parts();

  void grow();
  void prepareHulls();
  void addJoints();
  /// Makes room for what `remove` gathers, which must not allocate.
  void makeRoom();
  /// Removes the bodies and joints from these slots on, of which some may be known only in part. Does not allocate.
  void shorten(world::Slot links, world::Slot joints, std::size_t movingLinks) noexcept;
  void remove(const world::Removal& removal);
  void setAside(const world::Entities::Switched& switched);
  void transferKeptTouches(StateArchive& archive);
  /// Removes the bodies of these links from collision detection.
  void takeOut(std::span<const world::Slot> links);
  /// Sets the slots of bodies and joints, and the lists of those that move.
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
  Stepper stepper;
  /// What joints to the world hold on to.
  btRigidBody anchor{btRigidBody::btRigidBodyConstructionInfo(0, nullptr, nullptr)};
  /// One a link, in the order of their slots.
  std::vector<base::Arena::Pointer<Body>> bodies;
  std::vector<Body*> moving;
  /// One a joint, in the order of their slots.
  std::vector<base::Arena::Pointer<Joint>> joints;
  /// For each joint, the number of joints between moving bodies up to it.
  std::vector<std::size_t> holdingEnd;
  FrictionFrames frictionFrames;
  /// The contacts of two links of which one, or both, are set aside.
  struct KeptTouch {
    LinkId linkA;
    LinkId linkB;
    ManifoldPoints points;
  };
  std::vector<KeptTouch> keptTouches;
  /// Room for what is gathered while bodies go.
  struct Scratch {
    std::vector<btRigidBody*> freed;
    std::vector<btRigidBody*> bodies;
    std::vector<Joint*> joints;
    std::vector<base::Arena::Pointer<Body>> gone;
  };
  Scratch scratch;
  /// Length of the last step [s].
  double dt = 1;
};

Engine::Parts::~Parts() {
  scratch.bodies.clear();
  for (const auto& body : bodies) {
    if (body->rigid().getBroadphaseHandle() != nullptr) scratch.bodies.push_back(&body->rigid());
  }
  stepper.collisions().remove(scratch.bodies);
}

void Engine::Parts::grow() {
  prepareHulls();
  makeRoom();
  const world::Slot firstLink = bodies.size(), firstJoint = joints.size();
  const std::size_t movingBefore = moving.size();
  try {
    for (world::Slot link = firstLink; link < entities.links().size(); ++link) {
      bodies.push_back(arena.make<Body>(entities, link, gravity, hulls, shared));
    }
    // before bodies are added, because their pairs are filtered then
    filter.grow(entities.links().size(), entities.joints().size());
    for (world::Slot link = firstLink; link < bodies.size(); ++link) take(*bodies[link]);
    addJoints();
    renumberFrom(firstLink, firstJoint);
    frictionFrames.find(bodies, firstLink, entities);
  } catch (...) {
    shorten(firstLink, firstJoint, movingBefore);
    throw;
  }
  // last, because it discards contacts
  for (world::Slot slot = firstJoint; slot < joints.size(); ++slot) {
    stepper.collisions().separate(joints[slot]->parent(), joints[slot]->child());
  }
}

void Engine::Parts::makeRoom() {
  const auto reserve = [](auto& array, std::size_t count) {
    if (array.capacity() < count) array.reserve(std::max(count, 2 * array.capacity()));
  };
  reserve(scratch.freed, 2 * entities.joints().size());
  reserve(scratch.bodies, entities.links().size());
  reserve(scratch.joints, entities.joints().size());
  reserve(scratch.gone, entities.links().size());
}

void Engine::Parts::shorten(world::Slot links, world::Slot jointCount, std::size_t movingLinks) noexcept {
  frictionFrames.removeFrom(links);
  scratch.bodies.clear();
  for (world::Slot link = links; link < bodies.size(); ++link) {
    if (bodies[link]->rigid().getBroadphaseHandle() != nullptr) scratch.bodies.push_back(&bodies[link]->rigid());
  }
  stepper.collisions().remove(scratch.bodies);
  moving.resize(std::min(moving.size(), movingLinks));
  joints.erase(joints.begin() + static_cast<std::ptrdiff_t>(jointCount), joints.end());
  bodies.erase(bodies.begin() + static_cast<std::ptrdiff_t>(links), bodies.end());
  renumberFrom(links, jointCount);
  filter.update(links, jointCount);
}

void Engine::Parts::take(Body& body) {
  if (entities.links()[body.link()].isSetAside) return;
  if (body.moves() || body.collides()) stepper.collisions().add(body.rigid(), static_cast<int>(body.id().value));
}

// all at once, because they are computed in parallel
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
  const world::Slot first = joints.size();
  for (world::Slot slot = first; slot < entities.joints().size(); ++slot) {
    const world::JointRecord& record = entities.joints()[slot];
    const description::Joint& description = *record.description;
    joints.push_back(arena.make<Joint>(description, end(record.parentLink, description.X_ParentJoint),
                                       end(record.childLink, description.X_ChildJoint),
                                       end(record.referenceLink, description.X_ReferenceJoint)));
  }
  for (world::Slot slot = first; slot < joints.size(); ++slot) {
    const world::JointRecord& record = entities.joints()[slot];
    if (record.model == world::kNoSlot) continue;
    for (std::size_t i = 0; i < joints[slot]->axisCount(); ++i) {
      const std::optional<description::Mimic>& mimic = record.description->axes[i].mimic;
      const world::Slot leader = mimic ? entities.findJoint(record.model, mimic->joint) : world::kNoSlot;
      if (hasAxis(leader, mimic ? mimic->axis : 0)) joints[slot]->follow(i, *joints[leader], *mimic);
    }
  }
}

void Engine::Parts::remove(const world::Removal& removal) {
  std::vector<btRigidBody*>& freed = scratch.freed;
  freed.clear();
  for (const world::Slot slot : removal.joints) {
    freed.push_back(&joints[slot]->parent());
    freed.push_back(&joints[slot]->child());
  }
  takeOut(removal.links);
  frictionFrames.remove(removal.links);
  world::eraseSlots(joints, removal.joints);
  std::erase_if(keptTouches, [&](const KeptTouch& touch) {
    return std::ranges::any_of(removal.links, [&](world::Slot link) {
      return bodies[link]->id() == touch.linkA || bodies[link]->id() == touch.linkB;
    });
  });
  // removed bodies must live until their broad-phase handles have been checked below
  for (const world::Slot slot : removal.links) scratch.gone.push_back(std::move(bodies[slot]));
  world::eraseSlots(bodies, removal.links);
  renumberFrom(removal.links.empty() ? bodies.size() : removal.links.front(),
               removal.joints.empty() ? joints.size() : removal.joints.front());
  filter.update(bodies.size(), joints.size());
  std::erase_if(freed, [](const btRigidBody* body) { return body->getBroadphaseHandle() == nullptr; });
  std::ranges::sort(freed, {}, [this](const btRigidBody* body) { return bodyOf(*body).link(); });
  const auto repeated = std::ranges::unique(freed);
  freed.erase(repeated.begin(), repeated.end());
  for (btRigidBody* body : freed) stepper.collisions().findPairsOf(*body);
  scratch.gone.clear();
}

void Engine::Parts::takeOut(std::span<const world::Slot> links) {
  scratch.bodies.clear();
  for (const world::Slot link : links) {
    btRigidBody& rigid = bodies[link]->rigid();
    if (rigid.getBroadphaseHandle() != nullptr) scratch.bodies.push_back(&rigid);
  }
  stepper.collisions().remove(scratch.bodies);
}

void Engine::Parts::setAside(const world::Entities::Switched& switched) {
  std::vector<ManifoldPoints> touches;
  for (ManifoldPoints& points : listManifolds(stepper.collisions().dispatcher())) {
    const auto a = static_cast<world::Slot>(points.linkA), b = static_cast<world::Slot>(points.linkB);
    if (entities.links()[a].isSetAside || entities.links()[b].isSetAside) {
      keptTouches.push_back({bodies[a]->id(), bodies[b]->id(), std::move(points)});
    } else {
      touches.push_back(std::move(points));
    }
  }
  takeOut(switched.setAside);
  for (const world::Slot link : switched.returned) {
    bodies[link]->setGravity(gravity);
    take(*bodies[link]);
  }
  renumber();
  if (switched.returned.empty()) return;
  std::erase_if(keptTouches, [&](KeptTouch& touch) {
    const world::Slot a = entities.slot(touch.linkA), b = entities.slot(touch.linkB);
    if (a == world::kNoSlot || b == world::kNoSlot) return false;
    touch.points.linkA = static_cast<int>(a);
    touch.points.linkB = static_cast<int>(b);
    touches.push_back(std::move(touch.points));
    return true;
  });
  stepper.findTouches();
  restoreManifolds(touches, stepper.collisions().dispatcher());
}

void Engine::Parts::transferKeptTouches(StateArchive& archive) {
  std::size_t count = keptTouches.size();
  archive(count);
  archive.check(count <= archive.rest().size());
  if (archive.isGiving()) keptTouches.assign(count, KeptTouch());
  for (KeptTouch& touch : keptTouches) {
    // ids may be others in another run
    for (LinkId* id : {&touch.linkA, &touch.linkB}) {
      const auto found = std::ranges::lower_bound(bodies, *id, {}, [](const auto& body) { return body->id(); });
      auto slot = static_cast<std::uint64_t>(found - bodies.begin());
      archive(slot);
      if (archive.isGiving()) *id = slot < bodies.size() ? bodies[slot]->id() : LinkId();
    }
    archive(touch.points);
  }
}

void Engine::Parts::renumber() {
  renumberFrom(0, 0);
  frictionFrames.clear();
  frictionFrames.find(bodies, 0, entities);
}

void Engine::Parts::renumberFrom(world::Slot firstLink, world::Slot firstJoint) {
  // removed ones still have their old slots
  const auto kept = std::ranges::lower_bound(moving, firstLink, {}, &Body::link);
  const auto firstMember = static_cast<std::size_t>(kept - moving.begin());
  moving.erase(kept, moving.end());
  for (world::Slot link = firstLink; link < bodies.size(); ++link) {
    bodies[link]->setLink(link);
    if (bodies[link]->moves() && !entities.links()[link].isSetAside) moving.push_back(bodies[link].get());
  }
  stepper.setBodies(firstMember, std::span(moving).subspan(firstMember));

  for (world::Slot slot = firstJoint; slot < joints.size(); ++slot) joints[slot]->setSlot(slot);
  const std::size_t firstHolding = firstJoint == 0 ? 0 : holdingEnd[firstJoint - 1];
  holdingEnd.resize(firstJoint);
  std::vector<Joint*>& holding = scratch.joints;
  holding.clear();
  for (world::Slot slot = firstJoint; slot < joints.size(); ++slot) {
    if (joints[slot]->holdsSomething() && !entities.joints()[slot].isSetAside) holding.push_back(joints[slot].get());
    holdingEnd.push_back(firstHolding + holding.size());
  }
  stepper.setJoints(firstHolding, holding);
}

JointEnd Engine::Parts::end(world::Slot link, const Pose& X_LinkJoint) {
  if (link == world::kNoSlot) return {&anchor, toBullet(X_LinkJoint), false};
  Body& body = *bodies[link];
  return {&body.rigid(), toBullet(body.X_LinkBody().inverse() * X_LinkJoint), body.moves()};
}

Joint& Engine::Parts::jointWithAxis(world::Slot slot, std::size_t axis) {
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
      arena_(std::make_unique<base::Arena>()),
      parts_(std::make_unique<Parts>(entities, settings, *hulls_, *configuration_, *arena_)) {
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
  parts_->stepper.forgetBox(*parts_->bodies[link]);
  return true;
}

Engine::Reaction Engine::jointReaction(world::Slot joint) {
  Reaction reaction;
  parts_->joints[joint]->readReaction(reaction.force, reaction.torque);
  return reaction;
}

void Engine::contacts(std::vector<Contact>& contacts) const {
  listContacts(parts_->stepper.collisions().dispatcher(), parts_->entities, parts_->dt, contacts);
}

void Engine::grow() { parts_->grow(); }

void Engine::remove(const world::Removal& removal) { parts_->remove(removal); }

void Engine::reset() {
  // one after the other, because two at a time take twice the memory
  const world::Entities& entities = parts_->entities;
  const Settings settings = parts_->settings;
  parts_.reset();
  parts_ = std::make_unique<Parts>(entities, settings, *hulls_, *configuration_, *arena_);
}

void Engine::setGravity(const Vector3& gravity) {
  parts_->stepper.forgetRest();
  parts_->gravity = gravity;
  for (Body* body : parts_->moving) body->setGravity(gravity);
}

void Engine::setLinkPose(world::Slot link, const Pose& X_WorldLink) {
  Body& body = *parts_->bodies[link];
  body.setPose(X_WorldLink);
  parts_->stepper.collisions().moved(body.rigid());
  parts_->stepper.forgetRest();
}

void Engine::transfer(StateArchive& archive) {
  if (archive.isGiving()) reset();
  archive(parts_->dt);
  archive.check(parts_->dt >= 0 && parts_->dt <= description::kLongestSavedStep);
  for (const auto& body : parts_->bodies) body->transfer(archive);
  for (const auto& joint : parts_->joints) joint->transfer(archive);
  if (archive.isGiving()) {
    for (const auto& body : parts_->bodies) parts_->stepper.collisions().moved(body->rigid());
  }
  parts_->stepper.transferContacts(archive);
  parts_->transferKeptTouches(archive);
}

void Engine::step(Time dt, world::State& state) {
  assert(parts_->bodies.size() == state.links.size() && parts_->joints.size() == state.joints.size());
  parts_->dt = toSeconds(dt);
  if (!parts_->frictionFrames.empty()) parts_->stepper.forgetRest();
  parts_->frictionFrames.turn();
  parts_->stepper.step(parts_->dt, state);
  const world::Slot exploded = parts_->stepper.exploded();
  if (exploded != world::kNoSlot) parts_->reportExplosion(exploded);
}

void Engine::setSurfaceMotion(world::Slot link, std::size_t collision, const std::optional<SurfaceMotion>& motion) {
  parts_->stepper.forgetRest();
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
  if (part.slip1 != slip1 || part.slip2 != slip2) parts_->stepper.forgetRest();
  part.slip1 = slip1;
  part.slip2 = slip2;
}

std::pair<double, double> Engine::slip(world::Slot link, std::size_t collision) const {
  const LinkShape::Part& part = parts_->bodies[link]->shape().part(collision);
  return {part.slip1, part.slip2};
}

Engine::Mass Engine::mass(world::Slot link) const {
  const Body::Mass& mass = parts_->bodies[link]->mass();
  return {mass.mass, mass.inertiaFactor};
}

void Engine::setMass(world::Slot link, const Mass& mass) {
  parts_->bodies[link]->setMass({mass.mass, mass.inertiaFactor});
  parts_->stepper.forgetRest();
}

Engine::Feel Engine::feel(world::Slot link, std::size_t collision) const {
  const LinkShape::Feel feel = parts_->bodies[link]->shape().feel(collision);
  return {feel.mu, feel.mu2, feel.restitution};
}

void Engine::setFeel(world::Slot link, std::size_t collision, const Feel& feel) {
  Body& body = *parts_->bodies[link];
  const LinkShape::Feel wanted{feel.mu, feel.mu2, feel.restitution};
  if (body.shape().feel(collision) == wanted) return;
  body.shape().setFeel(collision, wanted);
  parts_->stepper.collisions().moved(body.rigid());
  parts_->stepper.forgetRest();
}

Engine::Resistance Engine::resistance(world::Slot joint, std::size_t axis) const {
  const Joint::Resistance resistance = parts_->joints[joint]->resistance(axis);
  return {resistance.damping, resistance.friction};
}

void Engine::setResistance(world::Slot joint, std::size_t axis, const Resistance& resistance) {
  parts_->joints[joint]->setResistance({resistance.damping, resistance.friction}, axis);
  parts_->stepper.forgetRest();
}

Engine::Bounds Engine::bounds(world::Slot joint, std::size_t axis) const {
  const Joint::Bounds bounds = parts_->joints[joint]->bounds(axis);
  return {bounds.lower, bounds.upper, bounds.effort};
}

void Engine::setBounds(world::Slot joint, std::size_t axis, const Bounds& bounds) {
  parts_->joints[joint]->setBounds({bounds.lower, bounds.upper, bounds.effort}, axis);
  parts_->stepper.forgetRest();
}

world::Slot Engine::slowedDown() const { return parts_->stepper.slowedDown(); }

std::optional<Engine::Crowding> Engine::crowding() const {
  BroadPhase& broadPhase = parts_->stepper.collisions().broadPhase();
  if (broadPhase.refusedPairs() == 0) return std::nullopt;
  const auto kept = static_cast<std::size_t>(broadPhase.getOverlappingPairCache()->getNumOverlappingPairs());
  return Crowding{kept + broadPhase.refusedPairs(), kept};
}

bool Engine::isJointDriven(world::Slot joint) const { return parts_->joints[joint]->isDriven(); }

void Engine::releaseJoint(world::Slot joint) { parts_->joints[joint]->release(); }

void Engine::setAside(const world::Entities::Switched& switched) { parts_->setAside(switched); }

}  // namespace pongsim::physics
