#include "world/entities.hh"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "support/world/nested_world.hh"

namespace pongsim::world {
namespace {

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

// outer's base and arm have a light each, the world has one
description::World litWorld() {
  description::World world = nestedWorld();
  world.models[0].links[0].lights.resize(1);
  world.models[0].links[0].lights[0].name = "lamp";
  world.models[1].links[0].lights = world.models[0].links[0].lights;
  world.lights.resize(1);
  world.lights[0].name = "sun";
  return world;
}

TEST(Entities, NumbersLightsBehindCollisionsAndThoseOfTheWorldLast) {
  const description::World world = litWorld();
  Entities entities(world);
  EXPECT_EQ(entities.lights()[0].id.value, 7U);
  EXPECT_EQ(visualId(entities.links()[0], 1).value, 5U);
  EXPECT_EQ(entities.lights()[2].link, kNoSlot);
  EXPECT_EQ(entities.nextId(), entities.lights()[2].id.value + 1);
  EXPECT_EQ(entities.findLight(kNoSlot, "lamp"), kNoSlot);
  EXPECT_EQ(entities.findLight(entities.findLink("lone::base"), "lamp"), 1U);
  EXPECT_EQ(entities.slot(entities.lights()[2].id), entities.findLight(kNoSlot, "sun"));
}

TEST(Entities, LosesLightsWithTheirLinks) {
  const description::World world = litWorld();
  Entities entities(world);
  const LightId lamp = entities.lights()[1].id;
  entities.removeModel(entities.findModel("outer"));
  ASSERT_EQ(entities.lights().size(), 2U);
  EXPECT_EQ(entities.slot(lamp), 0U);
  EXPECT_EQ(entities.lights()[0].link, entities.findLink("lone::base"));
  EXPECT_EQ(entities.lights()[1].link, kNoSlot);
}

TEST(Entities, TakesChangesOfLightsBackAtAReset) {
  const description::World world = litWorld();
  Entities entities(world);
  const Slot sun = entities.findLight(kNoSlot, "sun");
  auto moon = std::make_shared<description::Light>();
  moon->name = "moon";
  const LightId moonId = entities.lights()[entities.insertLight(moon)].id;
  auto dim = std::make_shared<description::Light>(world.lights[0]);
  dim->intensity = 0.5;
  entities.changeLight(sun, dim);
  EXPECT_EQ(entities.lights()[sun].description->intensity, 0.5);
  entities.removeLight(sun);
  EXPECT_EQ(entities.slot(moonId), sun);
  entities.reset();
  ASSERT_EQ(entities.lights().size(), 3U);
  EXPECT_EQ(entities.lights()[sun].description->intensity, 1);
  EXPECT_EQ(entities.slot(moonId), kNoSlot);
}

TEST(Entities, TakesOtherDescriptionsOfLinksBackAtAReset) {
  const description::World world = nestedWorld();
  Entities entities(world);
  const Slot base = entities.findLink("outer::base");
  const auto wide = [&] {
    auto link = std::make_shared<description::Link>(*entities.links()[base].description);
    link->collisions[0].geometry = description::Sphere{7};
    return link;
  };
  const auto isWide = [&] {
    const bool isInLink = entities.links()[base].description->collisions[0].geometry.index() == 2;
    EXPECT_EQ(&entities.links()[base].description->collisions[0], entities.collisions()[0].description);
    return isInLink;
  };
  const CollisionId id = entities.collisions()[0].id;
  entities.changeLink(base, wide());
  EXPECT_TRUE(isWide());
  EXPECT_EQ(entities.slot(id), 0U);
  entities.changeLink(base, wide());
  entities.changeLink(base, nullptr);
  EXPECT_FALSE(isWide());
  EXPECT_EQ(entities.links()[base].description, &world.models[0].links[0]);
  entities.changeLink(base, wide());
  entities.reset();
  EXPECT_FALSE(isWide());
  // the engine removes bodies after their entities, and reads their descriptions
  entities.changeLink(base, wide());
  const std::weak_ptr<const description::Link> last = entities.links()[base].changed;
  const Removal removal = entities.removeModel(entities.findModel("outer"));
  EXPECT_FALSE(last.expired());
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

TEST(Entities, TakeAModelInAtTheEnd) {
  const description::World world = nestedWorld();
  Entities entities(world);
  auto model = std::make_shared<description::Model>(world.models[0]);
  model->name = "third";
  const std::uint64_t lastId = entities.nextId();
  const Slot slot = entities.insertModel(model);
  EXPECT_EQ(slot, 3U);
  EXPECT_GT(entities.models()[slot].id.value, lastId);
  EXPECT_EQ(entities.topLevelModels().back(), slot);
  EXPECT_EQ(entities.joints().back().childLink, entities.findLink("third::inner::tip"));
  expectWhole(entities);

  const std::weak_ptr<const description::Model> watched = model;
  model.reset();
  EXPECT_FALSE(watched.expired());
  {
    const Removal removal = entities.removeModel(slot);
    EXPECT_FALSE(watched.expired());
  }
  EXPECT_TRUE(watched.expired());
  expectWhole(entities);
}

TEST(Entities, StayAsTheyAreWhereAModelCanNotBe) {
  const description::World world = nestedWorld();
  Entities entities(world);
  auto model = std::make_shared<description::Model>(world.models[0]);
  model->name = "third";
  model->joints[0].child = "nobody";
  EXPECT_THROW(entities.insertModel(model), std::invalid_argument);
  EXPECT_EQ(entities.models().size(), 3U);
  EXPECT_EQ(entities.findModel("third"), kNoSlot);
  expectWhole(entities);
}

TEST(Entities, GoBackToTheStartWithTheIdsOfTheStart) {
  const description::World world = nestedWorld();
  Entities entities(world);
  const ModelId lone = entities.models()[entities.findModel("lone")].id;
  auto model = std::make_shared<description::Model>(world.models[1]);
  model->name = "third";
  entities.insertModel(model);
  entities.removeModel(entities.findModel("lone"));
  const std::uint64_t lastId = entities.nextId();
  entities.reset();
  EXPECT_EQ(entities.models()[entities.findModel("lone")].id, lone);
  EXPECT_EQ(entities.findModel("third"), kNoSlot);
  EXPECT_GT(entities.nextId(), lastId);
  expectWhole(entities);
}

TEST(Entities, TellWhichJointsAreAroundALink) {
  const description::World world = nestedWorld();
  const Entities entities(world);
  ASSERT_EQ(entities.worldJoints().size(), 1U);
  EXPECT_EQ(entities.joints()[entities.slot(entities.worldJoints()[0])].description->name, "bridge");
  for (const char* link : {"outer::base", "outer::inner::tip"}) {
    const auto around = entities.jointsAround(entities.findLink(link));
    ASSERT_EQ(around.size(), 1U) << link;
    EXPECT_EQ(around[0].description->name, "joint");
  }
  EXPECT_TRUE(entities.jointsAround(entities.findLink("lone::base")).empty());
}

}  // namespace
}  // namespace pongsim::world
