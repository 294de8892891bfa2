#include "benchmark/multi_body.hh"

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyJointMotor.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>
#include <btBulletDynamicsCommon.h>

#include <cmath>
#include <stdexcept>
#include <utility>

#include "benchmark/bare_shape.hh"
#include "physics/convert.hh"

namespace pongsim::benchmark {

using physics::toBullet;

struct MultiBodyWorld::Parts {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btMultiBodyConstraintSolver solver;
  btMultiBodyDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};
  std::vector<std::unique_ptr<btCollisionShape>> shapes;
  std::vector<std::unique_ptr<btMultiBody>> bodies;
  std::vector<std::unique_ptr<btCollisionObject>> colliders;
  std::vector<std::pair<std::string, std::unique_ptr<btMultiBodyJointMotor>>> motors;
};

MultiBodyWorld::MultiBodyWorld(const description::World& world, int iterations) : parts_(std::make_unique<Parts>()) {
  parts_->configuration.setPlaneConvexMultipointIterations(4, 4);
  parts_->world.setGravity(toBullet(world.gravity));
  parts_->world.getSolverInfo().m_numIterations = iterations;
  parts_->world.getSolverInfo().m_leastSquaresResidualThreshold = 0;
  for (const description::Model& model : world.models) {
    if (model.isStatic) {
      addStatic(model);
    } else {
      addTree(model);
    }
  }
}

MultiBodyWorld::~MultiBodyWorld() {
  for (auto& [name, motor] : parts_->motors) parts_->world.removeMultiBodyConstraint(motor.get());
  for (auto& collider : parts_->colliders) parts_->world.removeCollisionObject(collider.get());
  for (auto& body : parts_->bodies) parts_->world.removeMultiBody(body.get());
}

void MultiBodyWorld::addStatic(const description::Model& model) {
  auto object = std::make_unique<btCollisionObject>();
  object->setCollisionShape(addShape(model.links.front()));
  object->setWorldTransform(toBullet(model.X_ParentModel * model.links.front().X_ModelLink));
  object->setFriction(1);
  parts_->world.addCollisionObject(object.get());
  parts_->colliders.push_back(std::move(object));
}

void MultiBodyWorld::addTree(const description::Model& model) {
  std::unordered_map<std::string, const description::Link*> links;
  for (const description::Link& link : model.links) links[link.name] = &link;
  const bool isFixed = model.joints.front().parent == "world";
  const description::Link* base = isFixed ? nullptr : links.at(model.joints.front().parent);
  auto made = std::make_unique<btMultiBody>(static_cast<int>(model.joints.size()), isFixed ? 0 : base->inertial.mass,
                                            isFixed ? btVector3(0, 0, 0) : toBullet(base->inertial.moments.diagonal()),
                                            isFixed, false);
  btMultiBody& body = *made;
  body.setBaseWorldTransform(toBullet(isFixed ? model.X_ParentModel : model.X_ParentModel * base->X_ModelLink));
  std::unordered_map<std::string, int> indices;
  if (base != nullptr) indices[base->name] = -1;
  indices["world"] = -1;
  for (int i = 0; i < static_cast<int>(model.joints.size()); ++i) {
    const description::Joint& joint = model.joints[static_cast<std::size_t>(i)];
    const description::Link& child = *links.at(joint.child);
    const btQuaternion turn =
        toBullet((joint.X_ParentJoint.rotation * joint.X_ChildJoint.rotation.conjugate()).conjugate());
    const btVector3 toPivot = toBullet(joint.X_ParentJoint.position);
    const btVector3 fromPivot = -toBullet(joint.X_ChildJoint.position);
    const btVector3 moments = toBullet(child.inertial.moments.diagonal());
    const int parent = indices.at(joint.parent);
    if (joint.type == description::JointType::kRevolute) {
      body.setupRevolute(i, child.inertial.mass, moments, parent, turn,
                         toBullet(joint.X_ChildJoint.rotation * joint.axes.front().xyz), toPivot, fromPivot, true);
    } else if (joint.type == description::JointType::kBall) {
      body.setupSpherical(i, child.inertial.mass, moments, parent, turn, toPivot, fromPivot, true);
    } else {
      throw std::invalid_argument("no such joint in reduced coordinates here");
    }
    indices[joint.child] = i;
  }
  body.finalizeMultiDof();
  body.setHasSelfCollision(false);
  body.setCanSleep(false);
  body.setLinearDamping(0);
  body.setAngularDamping(0);
  body.setMaxCoordinateVelocity(1e6);
  parts_->world.addMultiBody(&body);
  if (base != nullptr) addCollider(body, -1, *base);
  for (const description::Joint& joint : model.joints)
    addCollider(body, indices.at(joint.child), *links.at(joint.child));
  // initially, Bullet detects contacts before it has computed the poses of the links
  btAlignedObjectArray<btQuaternion> turns;
  btAlignedObjectArray<btVector3> origins;
  body.forwardKinematics(turns, origins);
  body.updateCollisionObjectWorldTransforms(turns, origins);
  for (int i = 0; !isFixed && i < static_cast<int>(model.joints.size()); ++i) {
    const description::Joint& joint = model.joints[static_cast<std::size_t>(i)];
    if (joint.type != description::JointType::kRevolute) continue;
    auto motor = std::make_unique<btMultiBodyJointMotor>(&body, i, 0, 1e10);
    parts_->world.addMultiBodyConstraint(motor.get());
    parts_->motors.emplace_back(joint.name, std::move(motor));
  }
  parts_->bodies.push_back(std::move(made));
}

void MultiBodyWorld::addCollider(btMultiBody& body, int index, const description::Link& link) {
  if (link.collisions.empty()) return;
  auto collider = std::make_unique<btMultiBodyLinkCollider>(&body, index);
  collider->setCollisionShape(addShape(link));
  collider->setFriction(1);
  if (index < 0) {
    collider->setWorldTransform(body.getBaseWorldTransform());
    body.setBaseCollider(collider.get());
  } else {
    body.getLink(index).m_collider = collider.get();
  }
  parts_->world.addCollisionObject(collider.get(), btBroadphaseProxy::DefaultFilter, btBroadphaseProxy::AllFilter);
  parts_->colliders.push_back(std::move(collider));
}

btCollisionShape* MultiBodyWorld::addShape(const description::Link& link) {
  if (link.collisions.size() != 1 || !link.collisions[0].X_LinkCollision.position.isZero(0)) {
    throw std::invalid_argument("one collision in the middle of each link here");
  }
  return parts_->shapes.emplace_back(bareShape(link.collisions[0].geometry)).get();
}

void MultiBodyWorld::setVelocity(std::string_view joint, double velocity) {
  for (auto& [name, motor] : parts_->motors) {
    if (name == joint) motor->setVelocityTarget(velocity, 1);
  }
}

void MultiBodyWorld::step(double dt) { parts_->world.stepSimulation(dt, 0); }

Vector3 MultiBodyWorld::basePosition() const {
  const btVector3 position = parts_->bodies.front()->getBaseWorldTransform().getOrigin();
  return {position.x(), position.y(), position.z()};
}

double MultiBodyWorld::angle(int joint) const { return parts_->bodies.front()->getJointPos(joint); }

double MultiBodyWorld::rate(int joint) const { return parts_->bodies.front()->getJointVel(joint); }

}  // namespace pongsim::benchmark
