// Bodies that are set aside and restored, among bodies in contact.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "physics/engine.hh"
#include "support/physics/rig.hh"

namespace pongsim::physics {
namespace {

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

/// Sets the models of these names aside and returns all others.
void setAside(test::Rig& rig, const std::vector<std::string>& models) {
  std::vector<std::uint64_t> ids;
  for (const world::ModelRecord& model : rig.entities.models()) {
    if (std::ranges::find(models, model.scopedName) != models.end()) ids.push_back(model.id.value);
  }
  rig.engine.setAside(rig.entities.setAside(ids));
}

const std::vector<std::string> kTower = {"box0", "box2", "box4"};

const world::LinkState& boxState(const test::Rig& rig, int box) { return rig.state.links[static_cast<Slot>(box + 1)]; }

TEST(SetAside, ChangesNoBitOfWhatStaysOrOfWhatComesBack) {
  for (const int moment : {50, 150, 400, 1500}) {
    test::Rig always(towers()), rig(towers());
    always.step(moment);
    rig.step(moment);
    setAside(rig, kTower);
    const Pose X_Before = boxState(rig, 4).X_WorldLink;
    always.step(200);
    rig.step(200);
    for (const int box : {1, 3, 5}) {
      EXPECT_EQ(boxState(rig, box).X_WorldLink, boxState(always, box).X_WorldLink) << "what stays";
    }
    EXPECT_EQ(boxState(rig, 4).X_WorldLink, X_Before);
    // one tower is 200 steps behind the other
    setAside(rig, {});
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
  setAside(rig, {"box0", "box2"});
  std::vector<Contact> contacts;
  rig.engine.contacts(contacts);
  for (const Contact& contact : contacts) {
    EXPECT_NE(rig.entities.slot(contact.collision1), world::kNoSlot);
    EXPECT_NE(rig.entities.slot(contact.collision2), world::kNoSlot);
  }
  rig.step(1000);
  EXPECT_LT(boxState(rig, 4).X_WorldLink.position.z(), 0.2);
  setAside(rig, {});
  rig.step(1000);
}

TEST(SetAside, FallsWithTheGravityOfNow) {
  test::Rig rig(towers());
  setAside(rig, kTower);
  rig.engine.setGravity({0, 0, 0});
  setAside(rig, {});
  const double z = boxState(rig, 4).X_WorldLink.position.z();
  rig.step(50);
  EXPECT_EQ(boxState(rig, 4).X_WorldLink.position.z(), z);
}

TEST(SetAside, IsInTheSavedState) {
  // a box that swings and scrapes over the ground, and one far away
  description::World world;
  world.models = {test::makeGround(), shelfBox("box0", test::at(0, 0, 0.5)), shelfBox("box1", test::at(9, 0, 1))};
  world.models[1].joints.push_back(test::makeJoint("hinge", description::JointType::kRevolute, "world", "link",
                                                   test::at(0, 0.5, 0.55), test::at(0, 0.5, 0.05), Vector3::UnitX()));
  test::Rig always(world), rig(world), other(world);
  always.step(400);
  rig.step(400);
  setAside(rig, {"box0"});
  StateArchive saved;
  world::transfer(saved, rig.state);
  rig.engine.transfer(saved);
  const std::vector<std::byte> bytes = saved.take();
  setAside(other, {"box0"});
  StateArchive restored(bytes);
  world::transfer(restored, other.state);
  other.engine.transfer(restored);
  setAside(rig, {});
  setAside(other, {});
  for (int i = 0; i < 200; ++i) {
    always.step(1);
    rig.step(1);
    other.step(1);
    ASSERT_EQ(boxState(rig, 0).X_WorldLink, boxState(always, 0).X_WorldLink) << i;
    ASSERT_EQ(rig.joint(0).position, always.joint(0).position) << i;
    ASSERT_EQ(boxState(other, 0).X_WorldLink, boxState(always, 0).X_WorldLink) << i;
    ASSERT_EQ(other.joint(0).position, always.joint(0).position) << i;
  }
  EXPECT_GT(rig.joint(0).position, 0.1);
}

TEST(SetAside, MayBeFollowedByARemovalOfWhatItTouched) {
  test::Rig rig(towers());
  rig.step(3000);
  setAside(rig, {"box2"});
  const world::Removal removal = rig.entities.removeModel(rig.entities.findModel("box0"));
  rig.engine.remove(removal);
  rig.state.remove(removal);
  setAside(rig, {});
  rig.step(1000);
  EXPECT_LT(rig.state.links[rig.entities.findLink("box2::link")].X_WorldLink.position.z(), 0.25);
}

}  // namespace
}  // namespace pongsim::physics
