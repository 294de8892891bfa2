// Islands of bodies at rest: if a step would change nothing, it is skipped, with the same results.

#include "physics/islands/rest.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "physics/engine.hh"
#include "support/physics/rig.hh"

namespace pongsim::physics {
namespace {

using test::Rig;

description::Model shapeAt(const std::string& name, description::Geometry geometry, const Vector3& position) {
  description::Link link = test::makeLink("link", {0, 0, 0}, 1, {0.1, 0.1, 0.1});
  test::addCollision(link, std::move(geometry));
  description::Model model = test::makeModel(name, {link});
  model.X_ParentModel.position = position;
  return model;
}

// a box, a cylinder and a ball beside each other
description::World shapes() {
  description::World world;
  world.models = {test::makeGround(), shapeAt("box", description::Box{{1, 1, 1}}, {-750, 0, 0.5}),
                  shapeAt("cylinder", description::Cylinder{0.5, 1}, {1.5, 0.3, 0.5}),
                  shapeAt("ball", description::Sphere{0.5}, {3, 0, 0.5})};
  return world;
}

void expectSame(const world::State& one, const world::State& other) {
  for (std::size_t i = 0; i < one.links.size(); ++i) {
    const world::LinkState &a = one.links[i], &b = other.links[i];
    EXPECT_EQ(a.X_WorldLink.position, b.X_WorldLink.position) << "link " << i;
    EXPECT_EQ(a.X_WorldLink.rotation.coeffs(), b.X_WorldLink.rotation.coeffs()) << "link " << i;
    EXPECT_EQ(a.v_WorldLink, b.v_WorldLink) << "link " << i;
    EXPECT_EQ(a.w_WorldLink, b.w_WorldLink) << "link " << i;
  }
}

TEST(Rest, IsReachedToTheBitByWhatStandsOnTheGround) {
  Rig rig(shapes());
  rig.step(3000);
  const world::State before = rig.state;
  rig.step();
  expectSame(rig.state, before);
  rig.step(100);
  expectSame(rig.state, before);
}

// a restored engine does not know what is at rest, and solves everything
TEST(Rest, HasTheBitsOfWhatIsSolved) {
  Rig rig(shapes());
  rig.step(3000);
  StateArchive taken;
  rig.engine.transfer(taken);
  const std::vector<std::byte> bytes = taken.take();
  Rig other(shapes());
  StateArchive giving(bytes);
  other.engine.transfer(giving);
  rig.step(5);
  other.step(5);
  expectSame(other.state, rig.state);
}

TEST(Rest, EndsWhereSomethingPushes) {
  Rig rig(shapes());
  rig.step(3000);
  const Vector3 before = rig.link("ball::link").X_WorldLink.position;
  rig.engine.addLinkWrench(rig.entities.findLink("ball::link"), {1, 0, 0}, {0, 0, 0});
  rig.step(100);
  EXPECT_GT((rig.link("ball::link").X_WorldLink.position - before).x(), 1e-6);
}

TEST(Rest, EndsWhereAVelocityIsSet) {
  Rig rig(shapes());
  rig.step(3000);
  rig.engine.setLinkVelocity(rig.entities.findLink("box::link"), {0, 0, 1}, {0, 0, 0});
  rig.step(10);
  EXPECT_GT(rig.link("box::link").X_WorldLink.position.z(), 0.505);
}

TEST(Rest, EndsWhereGravityChanges) {
  Rig rig(shapes());
  rig.step(3000);
  rig.engine.setGravity({0, 0, 1});
  rig.step(100);
  for (const char* name : {"box::link", "cylinder::link", "ball::link"}) {
    EXPECT_GT(rig.link(name).X_WorldLink.position.z(), 0.504) << name;
  }
}

TEST(Rest, EndsWhereWhatBodiesStandOnIsTakenAway) {
  Rig rig(shapes());
  rig.step(3000);
  rig.engine.setLinkPose(0, {{0, 0, -1}, Quaternion::Identity()});
  rig.step(100);
  for (const char* name : {"box::link", "cylinder::link", "ball::link"}) {
    EXPECT_LT(rig.link(name).X_WorldLink.position.z(), 0.46) << name;
  }
}

// before the others in the file, which renumbers them, and after them
TEST(Rest, EndsWhereWhatBodiesStandOnIsRemoved) {
  for (const bool isLast : {false, true}) {
    description::World world = shapes();
    if (isLast) std::ranges::rotate(world.models, world.models.begin() + 1);
    Rig rig(world);
    rig.step(3000);
    const world::Removal removal = rig.entities.removeModel(rig.entities.findModel("ground"));
    rig.engine.remove(removal);
    rig.state.remove(removal);
    rig.step(100);
    for (const char* name : {"box::link", "cylinder::link", "ball::link"}) {
      EXPECT_LT(rig.link(name).X_WorldLink.position.z(), 0.46) << name << isLast;
    }
  }
}

TEST(Rest, LastsWhereAModelComesElsewhere) {
  Rig rig(shapes());
  rig.step(3000);
  const world::State before = rig.state;
  rig.entities.insertModel(
      std::make_shared<const description::Model>(shapeAt("guest", description::Sphere{0.5}, {20, 0, 3})));
  rig.engine.grow();
  rig.state.grow(rig.entities);
  rig.step(10);
  expectSame(before, rig.state);
  EXPECT_LT(rig.link("guest::link").X_WorldLink.position.z(), 3);
}

TEST(Rest, EndsWhereABodyComes) {
  description::World world = shapes();
  world.models.push_back(shapeAt("guest", description::Sphere{0.5}, {3.2, 0, 4}));
  Rig rig(world);
  rig.step(700);
  const double resting = rig.link("ball::link").X_WorldLink.position.x();
  rig.step(1000);
  EXPECT_LT(rig.link("ball::link").X_WorldLink.position.x(), resting - 0.01);
}

}  // namespace
}  // namespace pongsim::physics
