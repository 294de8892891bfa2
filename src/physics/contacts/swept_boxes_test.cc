#include "physics/contacts/swept_boxes.hh"

#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <gtest/gtest.h>

namespace pongsim::physics {
namespace {

/// A ball at the origin with a radius of 0.5 m.
struct Ball {
  Ball() {
    body.setBroadphaseHandle(&broadPhase.add({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}, &body, true, 1));
    boxes.resize(0, 1);
  }
  ~Ball() { broadPhase.destroyProxy(body.getBroadphaseHandle(), nullptr); }

  double highest() const { return body.getBroadphaseProxy()->m_aabbMax.x(); }
  void moveTo(double x) { body.setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(x, 0, 0))); }
  void update(double dt) { boxes.update(bodies, dt); }

  btSphereShape shape{0.5};
  btRigidBody body{btRigidBody::btRigidBodyConstructionInfo(1, nullptr, &shape, {1, 1, 1})};
  btRigidBody* bodies[1] = {&body};
  BroadPhase broadPhase;
  shared::Workers workers{1};
  SweptBoxes boxes{broadPhase, workers};
};

TEST(SweptBoxes, HoldABodyWhereItIsAndWhereItGets) {
  Ball ball;
  ball.body.setLinearVelocity({3, 0, 0});
  ball.update(0.1);
  EXPECT_NEAR(ball.highest(), 0.8 + gContactBreakingThreshold, 1e-12);
  EXPECT_NEAR(ball.body.getBroadphaseProxy()->m_aabbMin.x(), -0.5 - gContactBreakingThreshold, 1e-12);
}

TEST(SweptBoxes, StayUntilABodyIsMoved) {
  Ball ball;
  ball.update(0.1);
  const double before = ball.highest();
  ball.moveTo(5);
  ball.update(0.1);
  EXPECT_EQ(ball.highest(), before);
  ball.boxes.forget(0);
  ball.update(0.1);
  EXPECT_NEAR(ball.highest(), 5.5, 0.1);
  ball.moveTo(7);
  ball.boxes.sweep(ball.body, 0, 0.1);
  EXPECT_NEAR(ball.highest(), 7.5, 0.1);
}

TEST(SweptBoxes, AreOthersForAStepOfAnotherLength) {
  Ball ball;
  ball.body.setLinearVelocity({3, 0, 0});
  ball.update(0.1);
  ball.update(0.2);
  EXPECT_NEAR(ball.highest(), 1.1 + gContactBreakingThreshold, 1e-12);
}

TEST(SweptBoxes, AreThoseOfBodiesAtTheirPlacesUntilTheNextStep) {
  Ball ball;
  ball.body.setLinearVelocity({3, 0, 0});
  ball.update(0.1);
  ball.boxes.updateInPlace(ball.bodies);
  EXPECT_NEAR(ball.highest(), 0.5 + gContactBreakingThreshold, 1e-12);
  ball.update(0.1);
  EXPECT_NEAR(ball.highest(), 0.8 + gContactBreakingThreshold, 1e-12);
}

TEST(SweptBoxes, AreKeptInTheBroadPhaseBoxes) {
  Ball ball;
  ball.update(0.1);
  for (int i = 0; i < 50; ++i) {
    ball.moveTo(0.2 * i);
    ball.boxes.sweep(ball.body, 0, 0.1);
    ball.update(0.1);
    const btBroadphaseProxy& proxy = *ball.body.getBroadphaseProxy();
    EXPECT_TRUE(BroadPhase::updateAabb(*ball.body.getBroadphaseProxy(), proxy.m_aabbMin, proxy.m_aabbMax)) << i;
  }
}

}  // namespace
}  // namespace pongsim::physics
