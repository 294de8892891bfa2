#include "physics/engine.hh"

#include <deque>
#include <stdexcept>
#include <string>

#include "physics/body.hh"
#include "physics/contact_filter.hh"
#include "physics/contact_list.hh"
#include "physics/convert.hh"
#include "physics/dynamics_world.hh"
#include "physics/joint.hh"
#include "physics/surface.hh"

namespace pongsim::physics {

struct Engine::Parts {
  Parts(const world::Entities& entitiesOfWorld, const Settings& settings)
      : entities(entitiesOfWorld),
        filter(entities),
        world(settings),
        anchor(btRigidBody::btRigidBodyConstructionInfo(0, nullptr, nullptr)) {}
  ~Parts();

  void addBodies();
  void addJoints();
  JointEnd end(world::Slot link, const Pose& X_LinkJoint);
  Joint& axisJoint(world::Slot slot);
  [[noreturn]] void reportExplosion(world::Slot link) const;

  const world::Entities& entities;
  const ContactFilter filter;
  DynamicsWorld world;
  /// What joints to the world hold on to.
  btRigidBody anchor;
  /// One a link, in the order of their slots.
  std::deque<Body> bodies;
  std::vector<Body*> moving;
  /// One a joint, in the order of their slots.
  std::deque<Joint> joints;
  /// Length of the last step [s].
  double dt = 1;
};

Engine::Parts::~Parts() {
  for (Joint& joint : joints) world.bullet().removeConstraint(&joint);
  for (Body& body : bodies) {
    if (body.rigid().getBroadphaseHandle() != nullptr) world.bullet().removeRigidBody(&body.rigid());
  }
}

void Engine::Parts::addBodies() {
  world.bullet().getPairCache()->setOverlapFilterCallback(const_cast<ContactFilter*>(&filter));
  for (world::Slot link = 0; link < entities.links().size(); ++link) {
    Body& body = bodies.emplace_back(entities, link, entities.description().gravity);
    if (body.moves()) moving.push_back(&body);
    if (body.moves() || body.collides()) world.bullet().addRigidBody(&body.rigid());
  }
}

void Engine::Parts::addJoints() {
  for (const world::JointRecord& record : entities.joints()) {
    const description::Joint& description = *record.description;
    Joint& joint = joints.emplace_back(description, end(record.parentLink, description.X_ParentJoint),
                                       end(record.childLink, description.X_ChildJoint));
    const bool holdsSomething = joint.getRigidBodyA().getInvMass() > 0 || joint.getRigidBodyB().getInvMass() > 0;
    if (holdsSomething) world.bullet().addConstraint(&joint);
  }
}

JointEnd Engine::Parts::end(world::Slot link, const Pose& X_LinkJoint) {
  if (link == world::kNoSlot) return {&anchor, toBullet(X_LinkJoint), false};
  Body& body = bodies[link];
  return {&body.rigid(), toBullet(body.X_LinkBody().inverse() * X_LinkJoint), body.moves()};
}

Joint& Engine::Parts::axisJoint(world::Slot slot) {
  if (slot >= joints.size() || !joints[slot].hasAxis()) {
    throw std::invalid_argument("only a revolute, continuous or prismatic joint can be commanded");
  }
  return joints[slot];
}

void Engine::Parts::reportExplosion(world::Slot link) const {
  const world::LinkRecord& record = entities.links()[link];
  throw std::runtime_error("the motion of link '" + entities.models()[record.model].scopedName +
                           "::" + record.description->name + "' has no finite value any more");
}

Engine::Engine(const world::Entities& entities, const Settings& settings)
    : parts_(std::make_unique<Parts>(entities, settings)) {
  combineSurfacesAsFortress();
  parts_->addBodies();
  parts_->addJoints();
}

Engine::~Engine() = default;

void Engine::setJointVelocityTarget(world::Slot joint, double velocity) {
  parts_->axisJoint(joint).setVelocityTarget(velocity);
}

void Engine::addJointForce(world::Slot joint, double force) { parts_->axisJoint(joint).addForce(force); }

void Engine::addLinkWrench(world::Slot link, const Vector3& force, const Vector3& torque) {
  parts_->bodies[link].addWrench(force, torque);
}

bool Engine::setLinkVelocity(world::Slot link, const Vector3& linear, const Vector3& angular) {
  if (!parts_->bodies[link].moves()) return false;
  parts_->bodies[link].setVelocity(linear, angular);
  return true;
}

Engine::Reaction Engine::jointReaction(world::Slot joint) {
  Reaction reaction;
  parts_->joints[joint].readReaction(reaction.force, reaction.torque);
  return reaction;
}

void Engine::contacts(std::vector<Contact>& contacts) const {
  listContacts(*parts_->world.bullet().getDispatcher(), parts_->entities, parts_->dt, contacts);
}

void Engine::step(Time dt, world::State& state) {
  const double seconds = toSeconds(dt);
  parts_->dt = seconds;
  for (Joint& joint : parts_->joints) joint.prepare(seconds);
  parts_->world.step(seconds);
  for (const Body* body : parts_->moving) {
    if (!body->read(state.links[body->link()])) parts_->reportExplosion(body->link());
  }
  for (world::Slot i = 0; i < parts_->joints.size(); ++i) {
    parts_->joints[i].update();
    state.joints[i] = parts_->joints[i].state();
  }
}

}  // namespace pongsim::physics
