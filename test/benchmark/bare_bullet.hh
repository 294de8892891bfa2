#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "description/world.hh"

namespace pongsim::benchmark {

/// Whose solver a bare loop has, and whose settings of it.
enum class BareSolver { kPongsim, kBullet };

/// A world in Bullet as lean as one would write it by hand for robots on wheels, with nothing of pongsim but, if one
/// wants, the solver and its settings: what our own step is compared with. It does not even look at the result. Knows
/// boxes, spheres, cylinders, planes, revolute and ball joints.
class BareBullet {
 public:
  BareBullet(const description::World& world, BareSolver solver);
  ~BareBullet();

  /// Drives all joints of that name [rad/s].
  void setVelocity(std::string_view joint, double velocity);
  void step(double dt) { world_->stepSimulation(dt, 0); }
  /// @return Position of the first body of that link name.
  btVector3 position(std::string_view link) const;

 private:
  void addModel(const description::Model& model);
  void addLink(const description::Link& link, const btTransform& X_WorldModel, bool isStatic);
  btCollisionShape* addShape(const description::Geometry& geometry);
  void addJoint(const description::Joint& joint);

  struct Motor;
  std::unique_ptr<class btCollisionConfiguration> configuration_;
  std::unique_ptr<class btCollisionDispatcher> dispatcher_;
  std::unique_ptr<class btBroadphaseInterface> broadphase_;
  std::unique_ptr<class btConstraintSolver> solver_;
  std::unique_ptr<btDiscreteDynamicsWorld> world_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  std::vector<std::unique_ptr<btTypedConstraint>> joints_;
  std::vector<Motor> motors_;
  /// Of the model that was added last.
  std::unordered_map<std::string, btRigidBody*> bodyOfLink_;
  std::unordered_map<std::string, btRigidBody*> firstBody_;
};

}  // namespace pongsim::benchmark
