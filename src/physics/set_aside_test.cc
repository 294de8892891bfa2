// Bodies that are set aside and restored, among bodies in contact.

#include <gtest/gtest.h>

#include <cstdint>
#include <utility>
#include <vector>

#include "physics/engine.hh"
#include "support/physics/rig.hh"

namespace pongsim::physics {
namespace {

using world::Roots;
using world::Slot;

description::Model shelfBox(const std::string& name, const Pose& pose) {
  description::Link link = test::makeLink("link", {0, 0, 0}, 1, {0.02, 0.03, 0.04});
  test::addCollision(link, description::Box{{0.4, 0.3, 0.2}});
  description::Model model = test::makeModel(name, {link});
  model.X_ParentModel = pose;
  return model;
}

/// Two towers of three boxes each, which start to tumble.
description::World towers() {
  description::World world;
  world.models = {test::makeGround()};
  for (int i = 0; i < 6; ++i) {
    world.models.push_back(shelfBox("box" + std::to_string(i), {{i % 2 == 0 ? 0.0 : 5.0, 0.03 * i, 0.15 + 0.13 * i},
                                                                fromRollPitchYaw(0.1 * i, 0.2, 0.3 * i)}));
  }
  return world;
}

struct Shelf {
  world::Departure departure;
  std::vector<SetAside> bodies;
  std::vector<world::StatePart> state;
};

Shelf setAside(test::Rig& rig, const std::vector<Roots>& groups) {
  Shelf shelf;
  shelf.departure = rig.entities.setAside(groups);
  shelf.bodies = rig.engine.setAside(shelf.departure.slots);
  shelf.state = rig.state.setAside(shelf.departure.slots);
  return shelf;
}

void bringBack(test::Rig& rig, Shelf shelf) {
  const world::GroupSlots slots = rig.entities.bringBack(std::move(shelf.departure.groups));
  rig.engine.bringBack(slots, std::move(shelf.bodies));
  rig.state.bringBack(slots, std::move(shelf.state));
}

Roots tower(const test::Rig& rig, int first) {
  Roots roots;
  for (int i = first; i < 6; i += 2) {
    roots.models.push_back(rig.entities.findModel("box" + std::to_string(i)));
  }
  return roots;
}

const world::LinkState& boxState(const test::Rig& rig, int box) {
  return rig.state.links[rig.entities.findLink("box" + std::to_string(box) + "::link")];
}

TEST(SetAside, ChangesNoBitOfWhatStaysOrOfWhatComesBack) {
  for (const int moment : {50, 150, 400, 1500}) {
    test::Rig always(towers()), rig(towers());
    always.step(moment);
    rig.step(moment);
    Shelf shelf = setAside(rig, {tower(rig, 0)});
    EXPECT_EQ(rig.state.links.size(), 4U);
    always.step(200);
    rig.step(200);
    for (const int box : {1, 3, 5}) {
      EXPECT_EQ(boxState(rig, box).X_WorldLink, boxState(always, box).X_WorldLink) << "what stays";
    }
    // one tower is 200 steps behind the other
    bringBack(rig, std::move(shelf));
    test::Rig before(towers());
    before.step(moment);
    for (int i = 0; i < 100; ++i) {
      always.step(1);
      before.step(1);
      rig.step(1);
      for (const int box : {0, 2, 4}) {
        ASSERT_EQ(boxState(rig, box).X_WorldLink, boxState(before, box).X_WorldLink) << moment << ", step " << i;
        ASSERT_EQ(boxState(rig, box).w_WorldLink, boxState(before, box).w_WorldLink) << moment << ", step " << i;
      }
      for (const int box : {1, 3, 5}) {
        ASSERT_EQ(boxState(rig, box).X_WorldLink, boxState(always, box).X_WorldLink) << moment << ", step " << i;
      }
    }
  }
}

TEST(SetAside, LetsWhatStoodOnItFall) {
  test::Rig rig(towers());
  rig.step(3000);
  // all but the uppermost one of a tower
  Roots roots = tower(rig, 0);
  roots.models.pop_back();
  Shelf shelf = setAside(rig, {roots});
  std::vector<Contact> contacts;
  rig.engine.contacts(contacts);
  for (const Contact& contact : contacts) {
    EXPECT_NE(rig.entities.slot(contact.collision1), world::kNoSlot);
    EXPECT_NE(rig.entities.slot(contact.collision2), world::kNoSlot);
  }
  rig.step(1000);
  EXPECT_LT(boxState(rig, 4).X_WorldLink.position.z(), 0.2);
  bringBack(rig, std::move(shelf));
  rig.step(1000);
}

TEST(SetAside, FallsWithTheGravityOfNow) {
  test::Rig rig(towers());
  Shelf shelf = setAside(rig, {tower(rig, 0)});
  rig.engine.setGravity({0, 0, 0});
  bringBack(rig, std::move(shelf));
  const double z = boxState(rig, 4).X_WorldLink.position.z();
  rig.step(50);
  EXPECT_EQ(boxState(rig, 4).X_WorldLink.position.z(), z);
}

TEST(SetAside, OutlivesTheEnginesReset) {
  // a box that swings and scrapes over the ground, and one far away
  description::World world;
  world.models = {test::makeGround(), shelfBox("box0", test::at(0, 0, 0.5)), shelfBox("box1", test::at(9, 0, 1))};
  world.models[1].joints.push_back(test::makeJoint("hinge", description::JointType::kRevolute, "world", "link",
                                                   test::at(0, 0.5, 0.55), test::at(0, 0.5, 0.05), Vector3::UnitX()));
  test::Rig always(world), rig(world);
  always.step(400);
  rig.step(400);
  Shelf shelf = setAside(rig, {Roots{{rig.entities.findModel("box0")}, {}, {}}});
  rig.engine.reset();
  bringBack(rig, std::move(shelf));
  for (int i = 0; i < 200; ++i) {
    always.step(1);
    rig.step(1);
    ASSERT_EQ(boxState(rig, 0).X_WorldLink, boxState(always, 0).X_WorldLink) << i;
    ASSERT_EQ(rig.joint(0).position, always.joint(0).position) << i;
  }
  EXPECT_GT(rig.joint(0).position, 0.1);
}

}  // namespace
}  // namespace pongsim::physics
