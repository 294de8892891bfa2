#include <LinearMath/btAlignedAllocator.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "physics/engine.hh"
#include "support/physics/rig.hh"

namespace {

long allocations = 0;

void* counted(std::size_t size, std::size_t alignment) {
  ++allocations;
  const std::size_t rounded = (size + alignment - 1) / alignment * alignment;
  if (void* memory = std::aligned_alloc(alignment, rounded)) return memory;
  throw std::bad_alloc();
}

void* countedForBullet(std::size_t size, int alignment) { return counted(size, static_cast<std::size_t>(alignment)); }

}  // namespace

void* operator new(std::size_t size) { return counted(size, alignof(std::max_align_t)); }
void* operator new[](std::size_t size) { return counted(size, alignof(std::max_align_t)); }
void* operator new(std::size_t size, std::align_val_t align) { return counted(size, static_cast<std::size_t>(align)); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace pongsim::physics {
namespace {

using description::JointType;

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
  btAlignedAllocSetCustomAligned(countedForBullet, std::free);
  {
    test::Rig rig(cart());
    rig.engine.setJointVelocityTarget(0, 2);
    rig.engine.setJointVelocityTarget(1, 3);
    rig.engine.setSurfaceMotion(4, 0, SurfaceMotion{.speed = 0.1, .center = Vector3(0, 9, 0)});
    rig.step(1000);
    const long before = allocations;
    rig.step(2000);
    EXPECT_EQ(allocations - before, 0);
    EXPECT_GT(before, 0);
  }
}

}  // namespace
}  // namespace pongsim::physics
