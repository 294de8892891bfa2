#include "world/entities.hh"

#include <gtest/gtest.h>

namespace pongsim::world {
namespace {

description::Link link(std::string name, double x = 0) {
  description::Link result;
  result.name = std::move(name);
  result.X_ModelLink.position.x() = x;
  return result;
}

// outer { base, arm; joint; inner { tip } }, then lone { base }, then a joint between the two
description::World nestedWorld() {
  description::Model inner;
  inner.name = "inner";
  inner.canonicalLink = "tip";
  inner.X_ParentModel.position.z() = 5;
  inner.links = {link("tip", 1)};

  description::Model outer;
  outer.name = "outer";
  outer.canonicalLink = "inner::tip";
  outer.X_ParentModel = {{10, 0, 0}, fromRollPitchYaw(0, 0, 1)};
  outer.links = {link("base"), link("arm", 2)};
  outer.links[0].visuals.resize(2);
  outer.links[0].collisions.resize(1);
  outer.joints.resize(1);
  outer.joints[0].name = "joint";
  outer.joints[0].parent = "world";
  outer.joints[0].child = "inner::tip";
  outer.models = {inner};

  description::Model lone;
  lone.name = "lone";
  lone.canonicalLink = "base";
  lone.links = {link("base")};

  description::World world;
  world.models = {outer, lone};
  world.joints.resize(1);
  world.joints[0].name = "bridge";
  world.joints[0].parent = "outer::arm";
  world.joints[0].child = "lone::base";
  return world;
}

TEST(Entities, FindsNestedThingsByTheirScopedNames) {
  const description::World world = nestedWorld();
  const Entities entities(world);
  const Slot outer = entities.findModel("outer");
  const Slot inner = entities.findModel("outer::inner");
  ASSERT_NE(outer, kNoSlot);
  ASSERT_NE(inner, kNoSlot);
  EXPECT_EQ(entities.models()[inner].parent, outer);
  EXPECT_EQ(entities.findLink("outer::inner::tip"), entities.findLink(outer, "inner::tip"));
  EXPECT_EQ(entities.findLink(inner, "tip"), entities.findLink(outer, "inner::tip"));
  EXPECT_NE(entities.findLink(outer, "base"), entities.findLink("lone::base"));
  EXPECT_EQ(entities.findJoint(outer, "joint"), 0U);
  EXPECT_EQ(entities.findJoint(kNoSlot, "bridge"), 1U);
}

TEST(Entities, FindsNothingWhereThereIsNothing) {
  const description::World world = nestedWorld();
  const Entities entities(world);
  EXPECT_EQ(entities.findModel("inner"), kNoSlot);
  EXPECT_EQ(entities.findLink(entities.findModel("outer"), "tip"), kNoSlot);
  EXPECT_EQ(entities.findLink("nobody::base"), kNoSlot);
  EXPECT_EQ(entities.findJoint(entities.findModel("lone"), "joint"), kNoSlot);
  EXPECT_EQ(entities.findJoint(kNoSlot, "nobody::bridge"), kNoSlot);
  EXPECT_EQ(entities.slot(LinkId{999}), kNoSlot);
}

TEST(Entities, ConnectsJointsToLinksAndTheWorld) {
  const description::World world = nestedWorld();
  const Entities entities(world);
  EXPECT_EQ(entities.joints()[0].parentLink, kNoSlot);
  EXPECT_EQ(entities.joints()[0].childLink, entities.findLink("outer::inner::tip"));
  EXPECT_EQ(entities.joints()[1].model, kNoSlot);
  EXPECT_EQ(entities.joints()[1].parentLink, entities.findLink("outer::arm"));
}

TEST(Entities, NumbersInTheOrderOfTheFile) {
  const description::World world = nestedWorld();
  Entities entities(world);
  EXPECT_EQ(entities.worldId().value, 1U);
  EXPECT_EQ(entities.models()[entities.findModel("outer")].id.value, 2U);
  EXPECT_EQ(entities.links()[entities.findLink("outer::base")].id.value, 3U);
  // two visuals and a collision lie between
  EXPECT_EQ(entities.links()[entities.findLink("outer::arm")].id.value, 7U);
  EXPECT_EQ(entities.models()[entities.findModel("outer::inner")].id.value, 8U);
  EXPECT_EQ(entities.joints()[0].id.value, 10U);
  EXPECT_EQ(entities.joints()[1].id.value, 13U);
  EXPECT_EQ(entities.nextId(), 14U);
}

TEST(Entities, NumbersCollisionsBehindVisualsAndSensorsBehindWhatHoldsThem) {
  description::World world = nestedWorld();
  world.models[0].links[0].sensors.resize(2);
  world.joints[0].sensors.resize(1);
  const Entities entities(world);
  ASSERT_EQ(entities.collisions().size(), 1U);
  EXPECT_EQ(entities.collisions()[0].id.value, 6U);
  EXPECT_EQ(entities.links()[entities.collisions()[0].link].description->name, "base");
  EXPECT_EQ(entities.links()[entities.findLink("outer::arm")].firstCollision, 1U);
  ASSERT_EQ(entities.sensors().size(), 3U);
  EXPECT_EQ(entities.sensors()[1].id.value, 8U);
  EXPECT_EQ(entities.slot(entities.sensors()[1].id), 1U);
  EXPECT_EQ(entities.slot(CollisionId{8}), kNoSlot);
  EXPECT_EQ(entities.links()[entities.findLink("outer::arm")].id.value, 9U);
  EXPECT_EQ(entities.sensors()[2].link, kNoSlot);
  EXPECT_EQ(entities.joints()[entities.sensors()[2].joint].description->name, "bridge");
}

TEST(Entities, GivesTheSlotOfAnIdOfItsOwnKindOnly) {
  const description::World world = nestedWorld();
  const Entities entities(world);
  for (Slot slot = 0; slot < entities.links().size(); ++slot) {
    EXPECT_EQ(entities.slot(entities.links()[slot].id), slot);
    EXPECT_EQ(entities.slot(ModelId{entities.links()[slot].id.value}), kNoSlot);
  }
}

TEST(Entities, PassesStaticOnToNestedModels) {
  description::World world = nestedWorld();
  world.models[0].isStatic = true;
  const Entities entities(world);
  EXPECT_TRUE(entities.links()[entities.findLink("outer::inner::tip")].isStatic);
  EXPECT_FALSE(entities.links()[entities.findLink("lone::base")].isStatic);
}

TEST(Entities, RefusesAJointToALinkThatIsNotThere) {
  description::World world = nestedWorld();
  world.joints[0].child = "lone::nothing";
  EXPECT_THROW(Entities{world}, std::invalid_argument);
}

}  // namespace
}  // namespace pongsim::world
