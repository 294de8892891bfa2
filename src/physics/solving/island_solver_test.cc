#include "physics/solving/island_solver.hh"

#include <gtest/gtest.h>

#include <string>

#include "support/physics/rig.hh"

namespace pongsim::physics {
namespace {

using test::Rig;

// a tower of boxes that touch from the start; each of its faces has four points of contact, so twelve rows
description::World tower(int height) {
  const Vector3 size(0.4, 0.4, 0.2);
  description::World world;
  world.models = {test::makeGround()};
  for (int i = 0; i < height; ++i) {
    description::Link link = test::makeLink("link", {0, 0, 0.0999 + 0.1999 * i}, 1, test::boxMoments(1, size));
    test::addCollision(link, description::Box{size});
    world.models.push_back(test::makeModel("box" + std::to_string(i), {link}));
  }
  return world;
}

TEST(IslandSolver, KeepsATowerStandingWhicheverWayItIsSolved) {
  for (int mostDirectRows : {0, 1000}) {
    Settings settings;
    settings.mostDirectRows = mostDirectRows;
    Rig rig(tower(4), settings);
    rig.step(3000);
    EXPECT_NEAR(rig.link("box3::link").X_WorldLink.position.z(), 0.7, 2e-3);
    EXPECT_LT(rig.link("box3::link").X_WorldLink.position.head<2>().norm(), 2e-3);
  }
}

TEST(IslandSolver, KeepsFiftyBoxesStandingThoughTheyAreIterated) {
  Rig rig(tower(50));
  rig.step(1000);
  const Pose& X_WorldTop = rig.link("box49::link").X_WorldLink;
  EXPECT_LT(X_WorldTop.position.head<2>().norm(), 0.01);
  EXPECT_NEAR(X_WorldTop.position.z(), 9.9, 0.01);
}

// as robots of SubT are: fourteen feet of four points each, which start in the ground, and half a kilogram on a bracket
// of ten milligrams, which another one carries
description::World loadOnLightBrackets() {
  description::Link base = test::makeLink("base", {0, 0, 0.09}, 20, {1, 1, 1});
  for (int i = 0; i < 14; ++i) {
    test::addCollision(base, description::Box{{0.1, 0.1, 0.2}});
    base.collisions.back().name += std::to_string(i);
    base.collisions.back().X_LinkCollision.position = {0.2 * (i % 7), 0.4 * (i / 7), 0};
  }
  description::Model model =
      test::makeModel("robot", {base, test::makeLink("bracket", {0.3, 0.2, 0.3}, 1e-5, {1e-8, 1e-8, 1e-8}),
                                test::makeLink("holder", {0.3, 0.2, 0.35}, 1e-5, {1e-8, 1e-8, 1e-8}),
                                test::makeLink("load", {0.5, 0.2, 0.4}, 0.5, {1e-3, 1e-3, 1e-3})});
  using description::JointType;
  model.joints = {test::makeJoint("a", JointType::kFixed, "base", "bracket", test::at(0.3, 0.2, 0.21), Pose()),
                  test::makeJoint("b", JointType::kFixed, "bracket", "holder", test::at(0, 0, 0.05), Pose()),
                  test::makeJoint("c", JointType::kFixed, "holder", "load", test::at(0.2, 0, 0.05), Pose())};
  description::World world;
  world.models = {test::makeGround(), model};
  return world;
}

TEST(IslandSolver, KeepsAHeavyLoadOnLightLinks) {
  Rig rig(loadOnLightBrackets());
  for (int i = 0; i < 1000; ++i) {
    rig.step();
    ASSERT_LT(rig.link("robot::load").v_WorldLink.norm(), 0.02) << i;
  }
  const Vector3 offset = rig.link("robot::load").X_WorldLink.position - rig.link("robot::base").X_WorldLink.position;
  EXPECT_LT((offset - Vector3(0.5, 0.2, 0.31)).norm(), 1e-4) << offset.transpose();
}

TEST(IslandSolver, GoesOverToIterationsWhereAnIslandIsLarge) {
  // the same as with iterations alone, bit for bit, is what tells that the direct method had no part in it
  Settings iterative;
  iterative.solver = Solver::kGaussSeidel;
  Settings few;
  few.mostDirectRows = 30;
  Rig expected(tower(5), iterative);
  Rig given(tower(5), few);
  Rig direct(tower(2), few);
  Rig iterated(tower(2), iterative);
  for (Rig* rig : {&expected, &given, &direct, &iterated}) rig->step(200);
  EXPECT_EQ(world::stateHash(expected.state), world::stateHash(given.state));
  EXPECT_NE(world::stateHash(direct.state), world::stateHash(iterated.state));
}

}  // namespace
}  // namespace pongsim::physics
