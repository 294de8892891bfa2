#include "physics/contacts/contact_list.hh"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>

#include "support/physics/rig.hh"

namespace pongsim::physics {
namespace {

// ids: the ground's collision is 4; of the box's two, the foot comes first
description::World boxOnGround(double height) {
  description::Link box = test::makeLink("box", {0, 0, height}, 2, test::boxMoments(2, {0.2, 0.2, 0.2}));
  test::addCollision(box, description::Sphere{0.01});
  test::addCollision(box, description::Box{{0.2, 0.2, 0.2}});
  description::World world;
  world.models = {test::makeGround(), test::makeModel("box", {box})};
  return world;
}

TEST(ContactList, TellsWhoTouchesWhereAndHowHard) {
  test::Rig rig(boxOnGround(0.1));
  rig.step(500);
  std::vector<Contact> contacts;
  rig.engine.contacts(contacts);
  ASSERT_EQ(contacts.size(), 4U);
  Vector3 sum = Vector3::Zero();
  for (const Contact& contact : contacts) {
    EXPECT_EQ(contact.collision1, rig.entities.collisions()[0].id);
    // not the small sphere inside
    EXPECT_EQ(contact.collision2, rig.entities.collisions()[2].id);
    // on the ground, from the box
    EXPECT_NEAR((contact.normal - Vector3(0, 0, -1)).norm(), 0, 1e-9);
    EXPECT_NEAR(std::abs(contact.position.x()), 0.1, 1e-3);
    EXPECT_NEAR(std::abs(contact.position.y()), 0.1, 1e-3);
    EXPECT_NEAR(contact.position.z(), 0, 1e-3);
    EXPECT_GE(contact.depth, 0);
    EXPECT_LT(contact.depth, 1e-3);
    sum += contact.force;
  }
  // its weight
  EXPECT_NEAR((sum - Vector3(0, 0, -2 * 9.8)).norm(), 0, 1e-3);
}

TEST(ContactList, TellsTheForceOfFrictionToo) {
  test::Rig rig(boxOnGround(0.1));
  rig.step(500);
  std::vector<Contact> contacts;
  for (int i = 0; i < 200; ++i) {
    rig.engine.addLinkWrench(rig.entities.findLink("box::box"), {3, 0, 0}, Vector3::Zero());
    rig.step();
  }
  rig.engine.contacts(contacts);
  Vector3 sum = Vector3::Zero();
  for (const Contact& contact : contacts) sum += contact.force;
  EXPECT_NEAR((sum - Vector3(3, 0, -2 * 9.8)).norm(), 0, 1e-2) << sum.transpose();
}

// a bridge on two piers: which part of which
TEST(ContactList, TellsThePartsApartWhereBothHaveSeveral) {
  description::Link piers;
  piers.name = "piers";
  description::Link bridge = test::makeLink("bridge", {0, 0, 1.1}, 2, test::boxMoments(2, {2, 0.2, 0.2}));
  for (const double x : {-1.0, 1.0}) {
    test::addCollision(piers, description::Box{{0.2, 0.2, 2}});
    piers.collisions.back().X_LinkCollision.position.x() = x;
    test::addCollision(bridge, description::Box{{0.4, 0.4, 0.2}});
    bridge.collisions.back().X_LinkCollision.position.x() = x;
  }
  description::Model below = test::makeModel("piers", {piers});
  below.isStatic = true;
  description::World world;
  world.models = {below, test::makeModel("bridge", {bridge})};
  test::Rig rig(world);
  rig.step(200);
  std::vector<Contact> contacts;
  rig.engine.contacts(contacts);
  ASSERT_EQ(contacts.size(), 8U);
  for (const Contact& contact : contacts) {
    const std::size_t side = contact.position.x() < 0 ? 0 : 1;
    EXPECT_EQ(contact.collision1, rig.entities.collisions()[side].id);
    EXPECT_EQ(contact.collision2, rig.entities.collisions()[2 + side].id);
  }
}

// a post beside a field of eight triangles: a triangle's number must not pass for a collision's
TEST(ContactList, NamesAMeshAmongOtherParts) {
  description::TriangleMesh field;
  for (const double y : {-2.0, -1.0, 0.0, 1.0, 2.0}) {
    for (const double x : {-1.0, 1.0}) field.vertices.emplace_back(x, y, 0);
  }
  for (std::uint32_t row = 0; row < 4; ++row) {
    const std::uint32_t first = 2 * row;
    field.triangles.push_back({first, first + 1, first + 3});
    field.triangles.push_back({first, first + 3, first + 2});
  }
  description::Mesh mesh;
  mesh.triangles = std::make_shared<description::TriangleMesh>(field);
  description::Link ground;
  ground.name = "ground";
  test::addCollision(ground, description::Box{{0.2, 0.2, 2}});
  ground.collisions[0].X_LinkCollision.position = {5, 0, 0};
  test::addCollision(ground, mesh);
  description::Model below = test::makeModel("ground", {ground});
  below.isStatic = true;
  description::Link ball = test::makeLink("ball", {0.3, 1.4, 0.1}, 1, {0.004, 0.004, 0.004});
  test::addCollision(ball, description::Sphere{0.1});
  description::World world;
  world.models = {below, test::makeModel("ball", {ball})};
  test::Rig rig(world);
  rig.step(200);
  std::vector<Contact> contacts;
  rig.engine.contacts(contacts);
  ASSERT_FALSE(contacts.empty());
  for (const Contact& contact : contacts) {
    EXPECT_EQ(contact.collision1, rig.entities.collisions()[1].id);
    EXPECT_EQ(contact.collision2, rig.entities.collisions()[2].id);
  }
}

TEST(ContactList, IsEmptyWhereNothingTouches) {
  test::Rig rig(boxOnGround(0.11));
  std::vector<Contact> contacts(3);
  rig.engine.contacts(contacts);
  EXPECT_TRUE(contacts.empty());
  rig.step();
  rig.engine.contacts(contacts);
  EXPECT_TRUE(contacts.empty());
}

}  // namespace
}  // namespace pongsim::physics
