#pragma once

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "description/world.hh"
#include "physics/joint.hh"

namespace pongsim::benchmark {

/// The solver of a bare loop, with its settings.
enum class BareSolver { kPongsim, kBullet };

/// A minimal Bullet world for robots on wheels, as a reference for the cost of our own step. It has nothing of pongsim,
/// or only the solver with its joints and settings, and does not read the results of a step. Supports boxes, spheres, cylinders,
/// planes, revolute and ball joints.
class BareBullet {
 public:
  BareBullet(const description::World& world, BareSolver solver);
  ~BareBullet();

  /// Drives all joints with this name [rad/s].
  void setVelocity(std::string_view joint, double velocity);
  void step(double dt) { world_->stepSimulation(dt, 0); }
  /// @return Position of the first link with this name.
  btVector3 position(std::string_view link) const;

 private:
  void addModel(const description::Model& model);
  void addLink(const description::Link& link, const btTransform& X_WorldModel, bool isStatic);
  btCollisionShape* addShape(const description::Geometry& geometry);
  void addJoint(const description::Joint& joint);

  struct Motor;
  class OwnSolver;
  std::unique_ptr<class btCollisionConfiguration> configuration_;
  std::unique_ptr<class btCollisionDispatcher> dispatcher_;
  std::unique_ptr<class btBroadphaseInterface> broadphase_;
  std::unique_ptr<class btConstraintSolver> solver_;
  std::unique_ptr<btDiscreteDynamicsWorld> world_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  /// With pongsim's solver they only tell Bullet which bodies are connected.
  std::vector<std::unique_ptr<btTypedConstraint>> joints_;
  std::vector<std::unique_ptr<physics::Joint>> ownJoints_;
  std::vector<Motor> motors_;
  /// Bodies of the model that was added last.
  std::unordered_map<std::string, btRigidBody*> bodyOfLink_;
  std::unordered_map<std::string, btRigidBody*> firstBody_;
};

}  // namespace pongsim::benchmark
