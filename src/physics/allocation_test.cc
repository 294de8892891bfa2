#include <LinearMath/btAlignedAllocator.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "physics/engine.hh"
#include "support/counted_allocations.hh"
#include "support/physics/rig.hh"

namespace pongsim::physics {
namespace {

using description::JointType;

void* allocateForBullet(std::size_t size, int alignment) {
  return test::countedAllocation(size, static_cast<std::size_t>(alignment));
}

// a cart on two wheels and a skid, driven, and a box that lies about
description::World cart() {
  description::Link body = test::makeLink("body", {0, 0, 0.3}, 2, {0.1, 0.1, 0.1});
  test::addCollision(body, description::Box{{0.8, 0.4, 0.2}});
  test::addCollision(body, description::Sphere{0.1});
  body.collisions[1].X_LinkCollision.position = {0.3, 0, -0.2};
  std::vector<description::Link> links = {body};
  for (double y : {-0.3, 0.3}) {
    links.push_back(test::makeLink(y < 0 ? "right" : "left", {-0.2, y, 0.3}, 1, {0.02, 0.02, 0.04}));
    links.back().X_ModelLink.rotation = fromRollPitchYaw(-1.5707, 0, 0);
    test::addCollision(links.back(), description::Cylinder{0.3, 0.1});
  }
  description::Model model = test::makeModel("cart", links);
  for (std::size_t i : {1U, 2U}) {
    const Pose X_BodyWheel = links[0].X_ModelLink.inverse() * links[i].X_ModelLink;
    model.joints.push_back(
        test::makeJoint(links[i].name, JointType::kRevolute, "body", links[i].name, X_BodyWheel, Pose()));
  }
  description::Link box = test::makeLink("box", {0, 3, 0.1}, 1, {0.01, 0.01, 0.01});
  test::addCollision(box, description::Box{{0.2, 0.2, 0.2}});
  description::World world;
  world.models = {test::makeGround(), model, test::makeModel("box", {box})};
  return world;
}

TEST(Engine, AllocatesNothingInASteadyStep) {
  btAlignedAllocSetCustomAligned(allocateForBullet, std::free);
  {
    test::Rig rig(cart());
    rig.engine.setJointVelocityTarget(0, 2);
    rig.engine.setJointVelocityTarget(1, 3);
    rig.engine.setSurfaceMotion(4, 0, SurfaceMotion{.speed = 0.1, .center = Vector3(0, 9, 0)});
    rig.step(1000);
    const long before = test::allocations;
    rig.step(2000);
    EXPECT_EQ(test::allocations - before, 0);
    EXPECT_GT(before, 0);
  }
}

}  // namespace
}  // namespace pongsim::physics
