#include "physics/engine.hh"

#include <cassert>
#include <utility>

#include "description/limits.hh"
#include "physics/contacts/contact_list.hh"
#include "physics/contacts/surface.hh"
#include "physics/convert.hh"
#include "physics/engine_parts.hh"

namespace pongsim::physics {

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
  return {mass.mass, mass.inertiaFactor, mass.stretch};
}

bool Engine::canHave(world::Slot link, const Mass& mass) const {
  return parts_->bodies[link]->canHave({mass.mass, mass.inertiaFactor, mass.stretch});
}

void Engine::setMass(world::Slot link, const Mass& mass) {
  parts_->bodies[link]->setMass({mass.mass, mass.inertiaFactor, mass.stretch});
  parts_->stepper.forgetRest();
}

Engine::Inertia Engine::inertiaOfFile(world::Slot link) const {
  const Body& body = *parts_->bodies[link];
  return {body.momentsOfFile(), body.X_LinkBody().rotation};
}

void Engine::reshape(world::Slot link) {
  Body& body = *parts_->bodies[link];
  // its contacts refer to the shapes that go
  parts_->stepper.collisions().moved(body.rigid());
  body.reshape(*parts_->entities.links()[link].description, parts_->hulls, parts_->shared);
  parts_->stepper.collisions().moved(body.rigid());
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
  body.shape().setFeel(collision, wanted, body.rigid());
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
