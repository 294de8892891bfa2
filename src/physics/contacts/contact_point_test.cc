#include "physics/contacts/contact_point.hh"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "physics/hulls/hull_store.hh"
#include "physics/shapes/shape.hh"
#include "physics/shapes/shared_shapes.hh"
#include "support/physics/rig.hh"

namespace pongsim::physics {
namespace {

/// A box and a slab that touch at one point, their normal up.
class ContactPoint : public testing::Test {
 protected:
  ContactPoint() {
    for (description::Link* link : {&box_, &slab_}) test::addCollision(*link, description::Box{{1, 1, 1}});
    point_.m_normalWorldOnB = btVector3(0, 0, 1);
    point_.m_index0 = point_.m_index1 = 0;
    point_.m_combinedFriction = 1;
  }

  PointFriction settle() {
    HullStore hulls("");
    SharedShapes shared;
    const LinkShape one(box_, Pose(), true, hulls, shared), other(slab_, Pose(), false, hulls, shared);
    btRigidBody a(1, nullptr, one.root()), b(0, nullptr, other.root());
    a.setUserPointer(const_cast<LinkShape*>(&one));
    b.setUserPointer(const_cast<LinkShape*>(&other));
    const btPersistentManifold manifold(&a, &b, 0, 0.02, 0.02);
    return settlePoint(point_, manifold);
  }
  description::Surface& surface() { return box_.collisions[0].surface; }
  bool has(int flag) const { return (point_.m_contactPointFlags & flag) != 0; }

  description::Link box_ = test::makeLink("box", {0, 0, 0}, 1, {1, 1, 1});
  description::Link slab_ = test::makeLink("slab", {0, 0, -1}, 1, {1, 1, 1});
  btManifoldPoint point_;
};

TEST_F(ContactPoint, IsOrdinaryWhereTheSurfacesSayNothing) {
  const PointFriction found = settle();
  EXPECT_FALSE(found.isDirected);
  EXPECT_EQ(found.torsion, 0);
}

TEST_F(ContactPoint, TakesDirectionsSlipsAndTheSmallerCoefficients) {
  surface().mu = 0.5;
  surface().mu2 = 0.25;
  surface().fdir1 = {0, 1, 0};
  surface().slip2 = 0.01;
  const PointFriction found = settle();
  EXPECT_TRUE(found.isDirected);
  EXPECT_EQ(point_.m_combinedFriction, 0.5);
  EXPECT_EQ(found.mu2, 0.25);
  EXPECT_EQ(found.slip1, 0);
  EXPECT_EQ(found.slip2, 0.01);
  EXPECT_EQ(point_.m_lateralFrictionDir1.y(), 1);
  EXPECT_EQ(point_.m_lateralFrictionDir2.x(), -1);
  EXPECT_FALSE(has(BT_CONTACT_FLAG_LATERAL_FRICTION_INITIALIZED));
}

TEST_F(ContactPoint, TakesTorsionOfAPatchOfGivenRadius) {
  for (description::Link* link : {&box_, &slab_}) {
    link->collisions[0].surface.torsion.coefficient = 1;
    link->collisions[0].surface.torsion.patchRadius = 0.1;
  }
  const PointFriction found = settle();
  EXPECT_DOUBLE_EQ(found.torsion, 3 * std::numbers::pi / 16 * 0.1);
  EXPECT_FALSE(found.isDirected);
}

TEST_F(ContactPoint, TakesTorsionOfThePatchOfRadiusAndDepth) {
  box_.collisions[0].surface.torsion = {1, 0, 0.3, false, 0};
  slab_.collisions[0].surface.torsion = {1, 0, 0.6, true, 0};
  point_.setDistance(-0.001);
  // the curvatures add up: 1 / 0.3 + 1 / 0.6 = 1 / 0.2
  EXPECT_DOUBLE_EQ(settle().torsion, 3 * std::numbers::pi / 16 * std::sqrt(0.2 * 0.001));
}

// joints hold two bodies in each other, which contact pushes apart with all its force
TEST(SolverContact, KeepsTheAngularMomentumOfBodiesDeepInEachOther) {
  description::Model model;
  for (const char* name : {"shell", "middle", "core"})
    model.links.push_back(test::makeLink(name, {0, 0, 0}, 1, {1, 1, 1}));
  test::addCollision(model.links[0], description::Box{{0.4, 0.4, 0.4}});
  test::addCollision(model.links[2], description::Box{{0.1, 0.1, 0.1}});
  model.name = "model";
  model.canonicalLink = "shell";
  model.selfCollide = true;
  model.joints = {test::makeJoint("a", description::JointType::kFixed, "shell", "middle", Pose(), Pose()),
                  test::makeJoint("b", description::JointType::kFixed, "middle", "core", Pose(), Pose())};
  description::World world;
  world.gravity.setZero();
  world.models = {model};
  test::Rig rig(std::move(world));
  for (world::Slot link = 0; link < 3; ++link) rig.engine.setLinkVelocity(link, {0, 0, 0}, {0, 1, 0});
  rig.step(1000);
  for (const world::LinkState& link : rig.state.links) EXPECT_NEAR(link.w_WorldLink.y(), 1, 0.01);
}

}  // namespace
}  // namespace pongsim::physics
