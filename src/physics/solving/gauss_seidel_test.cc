#include "physics/solving/gauss_seidel.hh"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>
#include <gtest/gtest.h>

#include <vector>

namespace pongsim::physics {
namespace {

constexpr double kStep = 0.001;

/// A box that slides, tilts and sinks on a fixed one, and another one on top of it.
struct Pile {
  btBoxShape shape{{0.5, 0.5, 0.5}};
  btRigidBody ground{0, nullptr, &shape};
  btRigidBody lower{2, nullptr, &shape, btVector3(0.3, 0.4, 0.5)};
  btRigidBody upper{1, nullptr, &shape, btVector3(0.2, 0.1, 0.3)};
  btPersistentManifold onGround{&lower, &ground, 0, 0.02, BT_LARGE_FLOAT};
  btPersistentManifold onLower{&upper, &lower, 0, 0.02, BT_LARGE_FLOAT};

  Pile() {
    place(ground, 0, {0, 0, 0}, {0, 0, 0});
    place(lower, 1, {0.3, 0.2, -0.1}, {0.1, -0.4, 0.2});
    place(upper, 2, {-0.2, 0.1, -0.3}, {0.5, 0.3, 0});
    for (const double x : {-0.5, 0.5}) {
      for (const double y : {-0.5, 0.5}) {
        add(onGround, {x, y, 0.5}, -2e-6 * (1 + x));
        add(onLower, {x, y, 1.5}, 1e-5 * y);
      }
    }
  }
  static void place(btRigidBody& body, double z, const btVector3& linear, const btVector3& angular) {
    body.setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(0, 0, z)));
    body.updateInertiaTensor();
    body.setLinearVelocity(linear);
    body.setAngularVelocity(angular);
    if (body.getInvMass() == 0) return;
    // no gyroscopic term of Bullet's
    body.setFlags(0);
    body.applyCentralForce(btVector3(0, 0, -9.8) / body.getInvMass());
    body.applyTorque({0.1, 0.2, 0.3});
  }
  static void add(btPersistentManifold& manifold, const btVector3& position, double distance) {
    btManifoldPoint point(position, position, {0, 0, 1}, distance);
    point.m_positionWorldOnA = point.m_positionWorldOnB = position;
    point.m_combinedFriction = 0.4;
    point.m_appliedImpulse = 0.001;
    manifold.addManifoldPoint(point);
  }
  std::vector<btRigidBody*> bodies() { return {&lower, &upper}; }
  std::vector<btPersistentManifold*> manifolds() { return {&onGround, &onLower}; }
};

TEST(GaussSeidel, GivesTheBitsOfBulletsSequentialImpulses) {
  const Settings settings;
  Pile pile, expected;
  GaussSeidel(settings).solve(pile.bodies(), pile.manifolds(), {}, kStep);

  btContactSolverInfo info;
  info.m_timeStep = kStep;
  info.m_numIterations = settings.iterations;
  info.m_globalCfm = settings.cfm;
  info.m_erp2 = settings.contactErp;
  info.m_splitImpulse = 0;
  info.m_restitutionVelocityThreshold = 0;
  info.m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
  std::vector<btCollisionObject*> bodies = {&expected.lower, &expected.upper};
  std::vector<btPersistentManifold*> manifolds = expected.manifolds();
  btSequentialImpulseConstraintSolver().solveGroup(bodies.data(), 2, manifolds.data(), 2, nullptr, 0, info, nullptr,
                                                   nullptr);

  for (std::size_t i = 0; i < 2; ++i) {
    const btRigidBody &one = *pile.bodies()[i], &other = *expected.bodies()[i];
    EXPECT_EQ(one.getLinearVelocity(), other.getLinearVelocity()) << i;
    EXPECT_EQ(one.getAngularVelocity(), other.getAngularVelocity()) << i;
    EXPECT_GT(pile.manifolds()[i]->getContactPoint(0).m_appliedImpulse, 0);
    EXPECT_EQ(pile.manifolds()[i]->getContactPoint(0).m_appliedImpulse,
              expected.manifolds()[i]->getContactPoint(0).m_appliedImpulse);
  }
}

}  // namespace
}  // namespace pongsim::physics
