#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "support/world/nested_world.hh"
#include "world/entities.hh"

namespace pongsim::world {
namespace {

TEST(Removal, TakesAModelWithItsPartsAndTheJointsThatHoldIt) {
  description::World world = nestedWorld();
  world.models[0].links[0].sensors.resize(1);
  world.models[1].links[0].collisions.resize(2);
  world.models[1].links[0].sensors.resize(1);
  Entities entities(world);
  const JointId bridge = entities.joints()[1].id;
  const LinkId base = entities.links()[entities.findLink("lone::base")].id;
  const SensorId sensor = entities.sensors()[1].id;

  const Removal removal = entities.removeModel(entities.findModel("outer"));
  EXPECT_EQ(removal.links, (std::vector<Slot>{0, 1, 2}));
  EXPECT_EQ(removal.joints, (std::vector<Slot>{0, 1}));
  EXPECT_EQ(removal.models.size(), 2U);
  EXPECT_EQ(entities.slot(bridge), kNoSlot);
  EXPECT_EQ(entities.findModel("outer::inner"), kNoSlot);
  EXPECT_EQ(entities.slot(base), 0U);
  EXPECT_EQ(entities.slot(sensor), 0U);
  EXPECT_EQ(entities.sensors()[0].link, 0U);
  EXPECT_EQ(entities.topLevelModels(), (std::vector<Slot>{0}));
  expectWhole(entities);
}

TEST(Removal, TakesSeveralModelsAtOnceLikeOneAfterTheOther) {
  description::World world = nestedWorld();
  for (const char* name : {"more", "last"}) {
    world.models.push_back(world.models[0]);
    world.models.back().name = name;
  }
  Entities atOnce(world), inTurn(world);
  const std::vector<Slot> slots{atOnce.findModel("outer"), atOnce.findModel("more")};
  const Removal removal = atOnce.removeModels(slots);
  EXPECT_EQ(removal.links, (std::vector<Slot>{0, 1, 2, 4, 5, 6}));
  EXPECT_EQ(removal.models.size(), 4U);
  EXPECT_TRUE(std::ranges::is_sorted(removal.models));
  inTurn.removeModel(inTurn.findModel("more"));
  inTurn.removeModel(inTurn.findModel("outer"));
  ASSERT_EQ(atOnce.models().size(), inTurn.models().size());
  for (Slot slot = 0; slot < atOnce.models().size(); ++slot) {
    EXPECT_EQ(atOnce.models()[slot].scopedName, inTurn.models()[slot].scopedName);
    EXPECT_EQ(atOnce.models()[slot].id, inTurn.models()[slot].id);
    EXPECT_EQ(atOnce.models()[slot].links, inTurn.models()[slot].links);
  }
  expectWhole(atOnce);
  EXPECT_TRUE(atOnce.removeModels({}).models.empty());
}

TEST(Removal, TakesAModelWithoutLinks) {
  description::World world = nestedWorld();
  description::Model marker;
  marker.name = "marker";
  marker.isStatic = true;
  world.models.insert(world.models.begin(), marker);
  Entities entities(world);
  const Removal removal = entities.removeModel(entities.findModel("marker"));
  EXPECT_TRUE(removal.links.empty());
  EXPECT_EQ(entities.models().size(), 3U);
  expectWhole(entities);
}

TEST(Removal, TakesJointsOfModelsBeforeThoseOfTheWorld) {
  const description::World world = nestedWorld();
  Entities entities(world);
  auto joint = std::make_shared<description::Joint>();
  joint->name = "rope";
  joint->parent = "outer::base";
  joint->child = "lone::base";
  const Slot slot = entities.insertJoint(joint);
  EXPECT_EQ(entities.findJoint(kNoSlot, "rope"), slot);
  EXPECT_EQ(entities.joints()[slot].childLink, entities.findLink("lone::base"));
  const JointId id = entities.joints()[slot].id;
  entities.removeJoint(0);
  EXPECT_EQ(entities.slot(id), slot - 1);
  EXPECT_TRUE(entities.models()[entities.findModel("outer")].joints.empty());
  expectWhole(entities);
}

// of the outer model of `nestedWorld`, with something of each kind in it
description::Model fullModel(const std::string& name) {
  description::Model model = nestedWorld().models[0];
  model.name = name;
  model.links[0].sensors.resize(2);
  model.links[1].collisions.resize(2);
  model.links[1].lights.resize(1);
  model.joints[0].sensors.resize(1);
  model.models[0].links[0].sensors.resize(1);
  return model;
}

TEST(Removal, TakesNothingElseWhateverGoesFirst) {
  description::World world;
  for (int i = 0; i < 12; ++i) world.models.push_back(fullModel("start" + std::to_string(i)));
  for (int i = 0; i < 6; ++i) {
    description::Joint joint;
    joint.name = "bridge" + std::to_string(i);
    joint.parent = "start" + std::to_string(2 * i) + "::arm";
    joint.child = "start" + std::to_string((2 * i + 7) % 12) + "::inner::tip";
    joint.sensors.resize(1);
    world.joints.push_back(joint);
  }
  world.lights.resize(2);
  for (unsigned seed = 0; seed < 20; ++seed) {
    Entities entities(world);
    std::mt19937 random(seed);
    for (int i = 0; i < 6; ++i) {
      entities.insertModel(std::make_shared<description::Model>(fullModel("new" + std::to_string(i))));
    }
    while (!entities.topLevelModels().empty()) {
      if (random() % 4 == 0 && !entities.joints().empty()) {
        entities.removeJoint(random() % entities.joints().size());
      } else if (random() % 6 == 0 && !entities.lights().empty()) {
        const Slot light = random() % entities.lights().size();
        if (entities.lights()[light].link == kNoSlot) entities.removeLight(light);
      } else {
        std::vector<Slot> some;
        std::ranges::sample(entities.topLevelModels(), std::back_inserter(some), 1 + random() % 3, random);
        entities.removeModels(some);
      }
      expectWhole(entities);
    }
    EXPECT_TRUE(entities.links().empty());
    EXPECT_TRUE(entities.joints().empty());
    EXPECT_TRUE(entities.sensors().empty());
    EXPECT_TRUE(entities.collisions().empty());
  }
}

}  // namespace
}  // namespace pongsim::world
