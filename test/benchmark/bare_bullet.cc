#include "benchmark/bare_bullet.hh"

#include <BulletDynamics/ConstraintSolver/btHingeConstraint.h>
#include <BulletDynamics/ConstraintSolver/btPoint2PointConstraint.h>
#include <btBulletDynamicsCommon.h>

#include <span>
#include <stdexcept>

#include "benchmark/bare_shape.hh"
#include "physics/convert.hh"
#include "physics/settings.hh"
#include "physics/solving/island_solver.hh"

namespace pongsim::benchmark {

using physics::toBullet;

struct BareBullet::Motor {
  std::string name;
  btHingeConstraint* hinge;
  physics::Joint* joint;
};

/// Lets Bullet's world call pongsim's solver. Each of its constraints has a pointer to the joint in its place.
class BareBullet::OwnSolver final : public btConstraintSolver {
 public:
  btScalar solveGroup(btCollisionObject** bodies, int bodyCount, btPersistentManifold** manifolds, int manifoldCount,
                      btTypedConstraint** constraints, int count, const btContactSolverInfo& info, btIDebugDraw*,
                      btDispatcher*) override {
    bodies_.clear();
    joints_.clear();
    for (btCollisionObject* object : std::span(bodies, static_cast<std::size_t>(bodyCount))) {
      if (!object->isStaticObject()) bodies_.push_back(static_cast<btRigidBody*>(object));
    }
    for (btTypedConstraint* constraint : std::span(constraints, static_cast<std::size_t>(count))) {
      joints_.push_back(static_cast<physics::Joint*>(constraint->getUserConstraintPtr()));
      joints_.back()->prepare(info.m_timeStep);
    }
    solver_.solve(bodies_, std::span(manifolds, static_cast<std::size_t>(manifoldCount)), joints_, info.m_timeStep);
    for (physics::Joint* joint : joints_) joint->update();
    return 0;
  }
  void reset() override {}
  btConstraintSolverType getSolverType() const override { return BT_SEQUENTIAL_IMPULSE_SOLVER; }

 private:
  physics::IslandSolver solver_{physics::Settings()};
  std::vector<btRigidBody*> bodies_;
  std::vector<physics::Joint*> joints_;
};

BareBullet::BareBullet(const description::World& world, BareSolver solver) {
  auto configuration = std::make_unique<btDefaultCollisionConfiguration>();
  configuration->setPlaneConvexMultipointIterations(4, 4);
  configuration_ = std::move(configuration);
  dispatcher_ = std::make_unique<btCollisionDispatcher>(configuration_.get());
  broadphase_ = std::make_unique<btDbvtBroadphase>();
  if (solver == BareSolver::kPongsim) {
    solver_ = std::make_unique<OwnSolver>();
  } else {
    solver_ = std::make_unique<btSequentialImpulseConstraintSolver>();
  }
  world_ = std::make_unique<btDiscreteDynamicsWorld>(dispatcher_.get(), broadphase_.get(), solver_.get(),
                                                     configuration_.get());
  world_->setGravity(toBullet(world.gravity));
  world_->setForceUpdateAllAabbs(false);
  if (solver == BareSolver::kPongsim) world_->getSolverInfo().m_minimumSolverBatchSize = 1;
  for (const description::Model& model : world.models) addModel(model);
}

BareBullet::~BareBullet() {
  for (const auto& joint : joints_) world_->removeConstraint(joint.get());
  for (const auto& body : bodies_) world_->removeRigidBody(body.get());
}

void BareBullet::addModel(const description::Model& model) {
  bodyOfLink_.clear();
  for (const description::Link& link : model.links) addLink(link, toBullet(model.X_ParentModel), model.isStatic);
  for (const description::Joint& joint : model.joints) addJoint(joint);
}

void BareBullet::addLink(const description::Link& link, const btTransform& X_WorldModel, bool isStatic) {
  auto compound = std::make_unique<btCompoundShape>();
  btCollisionShape* shape = nullptr;
  for (const description::Collision& collision : link.collisions) {
    shape = addShape(collision.geometry);
    compound->addChildShape(toBullet(collision.X_LinkCollision), shape);
  }
  if (link.collisions.size() != 1 || !link.collisions[0].X_LinkCollision.position.isZero(0)) {
    shape = compound.get();
    shapes_.push_back(std::move(compound));
  }
  const Matrix3& moments = link.inertial.moments;
  if (!link.inertial.X_LinkCom.position.isZero(0) || !moments.isDiagonal(0)) {
    throw std::invalid_argument("no offset masses here");
  }
  btRigidBody::btRigidBodyConstructionInfo info(isStatic ? 0 : link.inertial.mass, nullptr, shape,
                                                toBullet(moments.diagonal()));
  info.m_startWorldTransform = X_WorldModel * toBullet(link.X_ModelLink);
  info.m_friction = 1;
  btRigidBody* body = bodies_.emplace_back(std::make_unique<btRigidBody>(info)).get();
  if (!isStatic) body->setActivationState(DISABLE_DEACTIVATION);
  world_->addRigidBody(body);
  bodyOfLink_[link.name] = body;
  firstBody_.emplace(link.name, body);
}

btCollisionShape* BareBullet::addShape(const description::Geometry& geometry) {
  return shapes_.emplace_back(bareShape(geometry)).get();
}

void BareBullet::addJoint(const description::Joint& joint) {
  btRigidBody& parent = *bodyOfLink_.at(joint.parent);
  btRigidBody& child = *bodyOfLink_.at(joint.child);
  const btVector3 inParent = toBullet(joint.X_ParentJoint.position);
  const btVector3 inChild = toBullet(joint.X_ChildJoint.position);
  if (joint.type == description::JointType::kBall) {
    joints_.push_back(std::make_unique<btPoint2PointConstraint>(parent, child, inParent, inChild));
  } else if (joint.type == description::JointType::kRevolute) {
    const Vector3& axis = joint.axes.front().xyz;
    // the angle of Bullet's hinge has the opposite sign, so the parent comes second
    auto hinge = std::make_unique<btHingeConstraint>(child, parent, inChild, inParent,
                                                     toBullet(joint.X_ChildJoint.rotation * axis),
                                                     toBullet(joint.X_ParentJoint.rotation * axis));
    motors_.push_back({joint.name, hinge.get(), nullptr});
    joints_.push_back(std::move(hinge));
  } else {
    throw std::invalid_argument("no such joint here");
  }
  ownJoints_.push_back(std::make_unique<physics::Joint>(
      joint, physics::JointEnd{&parent, toBullet(joint.X_ParentJoint), !parent.isStaticObject()},
      physics::JointEnd{&child, toBullet(joint.X_ChildJoint), !child.isStaticObject()}));
  joints_.back()->setUserConstraintPtr(ownJoints_.back().get());
  if (!motors_.empty() && motors_.back().hinge == joints_.back().get()) motors_.back().joint = ownJoints_.back().get();
  world_->addConstraint(joints_.back().get(), true);
}

void BareBullet::setVelocity(std::string_view joint, double velocity) {
  for (const Motor& motor : motors_) {
    if (motor.name != joint) continue;
    motor.hinge->enableAngularMotor(true, velocity, 1e10);
    motor.joint->setVelocityTarget(velocity, 0);
  }
}

btVector3 BareBullet::position(std::string_view link) const {
  return firstBody_.at(std::string(link))->getWorldTransform().getOrigin();
}

}  // namespace pongsim::benchmark
