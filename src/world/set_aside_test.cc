// Entities that are set aside and restored.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "world/entities.hh"
#include "world/state.hh"

namespace pongsim::world {
namespace {

description::Link shelfLink(std::string name, std::size_t collisions) {
  description::Link link;
  link.name = std::move(name);
  link.collisions.resize(collisions);
  link.visuals.resize(1);
  link.sensors.resize(1);
  link.lights.resize(1);
  return link;
}

/// A model of two links with a joint, and a nested one.
description::Model shelfModel(const std::string& name) {
  description::Model inner;
  inner.name = "inner";
  inner.canonicalLink = "tip";
  inner.links = {shelfLink("tip", 2)};
  description::Model model;
  model.name = name;
  model.canonicalLink = "base";
  model.links = {shelfLink("base", 1), shelfLink("arm", 0)};
  model.joints.resize(2);
  model.joints[0].name = "elbow";
  model.joints[0].parent = "base";
  model.joints[0].child = "arm";
  model.joints[0].sensors.resize(1);
  model.joints[1].name = "root";
  model.joints[1].parent = "world";
  model.joints[1].child = "inner::tip";
  model.models = {inner};
  return model;
}

/// a to d, a joint of the world between b and c, two lights and an actor.
description::World shelfWorld() {
  description::World world;
  for (const char* name : {"a", "b", "c", "d"}) world.models.push_back(shelfModel(name));
  world.joints.resize(1);
  world.joints[0].name = "bridge";
  world.joints[0].parent = "b::arm";
  world.joints[0].child = "c::base";
  world.lights.resize(2);
  world.lights[0].name = "sun";
  world.lights[1].name = "lamp";
  world.actors.resize(2);
  world.actors[0].name = "walker";
  world.actors[1].name = "runner";
  return world;
}

/// Everything about the entities that are there: ids, names and hierarchy.
std::vector<std::string> roster(const Entities& entities) {
  std::vector<std::string> lines;
  const auto link = [&](Slot slot) { return slot == kNoSlot ? "-" : std::to_string(entities.links()[slot].id.value); };
  for (const ModelRecord& model : present(entities.models())) {
    std::string line = "model " + std::to_string(model.id.value) + " " + model.scopedName + " canonical " +
                       link(model.canonicalLink) + " in " +
                       (model.parent == kNoSlot ? "-" : entities.models()[model.parent].scopedName) + " links";
    for (const Slot slot : model.links) line += " " + link(slot);
    for (const Slot slot : model.joints) line += " " + std::to_string(entities.joints()[slot].id.value);
    for (const Slot slot : model.models) line += " " + std::to_string(entities.models()[slot].id.value);
    EXPECT_EQ(entities.findModel(model.scopedName), static_cast<Slot>(&model - entities.models().data()));
    EXPECT_EQ(entities.slot(model.id), static_cast<Slot>(&model - entities.models().data()));
    lines.push_back(line);
  }
  for (const LinkRecord& each : present(entities.links())) {
    std::string line = "link " + std::to_string(each.id.value) + " " + each.description->name + " of " +
                       entities.models()[each.model].scopedName;
    for (std::size_t i = 0; i < each.description->collisions.size(); ++i) {
      line += " " + std::to_string(entities.collisions()[each.firstCollision + i].id.value);
    }
    EXPECT_EQ(entities.slot(each.id), static_cast<Slot>(&each - entities.links().data()));
    lines.push_back(line);
  }
  for (const JointRecord& joint : present(entities.joints())) {
    lines.push_back("joint " + std::to_string(joint.id.value) + " " + link(joint.parentLink) + " " +
                    link(joint.childLink) + " of " +
                    (joint.model == kNoSlot ? "-" : entities.models()[joint.model].scopedName));
  }
  for (const CollisionRecord& collision : present(entities.collisions())) {
    lines.push_back("collision " + std::to_string(collision.id.value) + " " + link(collision.link));
  }
  for (const SensorRecord& sensor : present(entities.sensors())) {
    lines.push_back("sensor " + std::to_string(sensor.id.value) + " " + link(sensor.link) + " " +
                    (sensor.joint == kNoSlot ? "-" : std::to_string(entities.joints()[sensor.joint].id.value)));
  }
  for (const LightRecord& light : present(entities.lights())) {
    lines.push_back("light " + std::to_string(light.id.value) + " " + light.description->name + " " + link(light.link));
  }
  for (const ActorRecord& actor : present(entities.actors())) {
    lines.push_back("actor " + std::to_string(actor.id.value) + " " + actor.description->name);
  }
  for (const Slot slot : entities.topLevelModels()) lines.push_back("top " + entities.models()[slot].scopedName);
  return lines;
}

/// @return The ids of these models, lights of the world and actors, in ascending order.
std::vector<std::uint64_t> idsOf(const Entities& entities, const std::vector<std::string>& names) {
  std::vector<std::uint64_t> ids;
  const auto isNamed = [&](const std::string& name) { return std::ranges::find(names, name) != names.end(); };
  for (const ModelRecord& model : entities.models()) {
    if (isNamed(model.scopedName)) ids.push_back(model.id.value);
  }
  for (const LightRecord& light : entities.lights()) {
    if (light.link == kNoSlot && isNamed(light.description->name)) ids.push_back(light.id.value);
  }
  for (const ActorRecord& actor : entities.actors()) {
    if (isNamed(actor.description->name)) ids.push_back(actor.id.value);
  }
  std::ranges::sort(ids);
  return ids;
}

TEST(SetAside, HidesModelsWithAllTheirParts) {
  const description::World world = shelfWorld();
  Entities entities(world);
  const std::vector<std::string> before = roster(entities);
  const Slot b = entities.findModel("b"), c = entities.findModel("c"), tip = entities.findLink("c::inner::tip");
  const LinkId base = entities.links()[entities.findLink("b::base")].id;
  const Entities::Switched switched = entities.setAside(idsOf(entities, {"b", "c", "sun", "walker"}));
  EXPECT_TRUE(switched.isAny);
  EXPECT_EQ(switched.setAside, (std::vector<Slot>{3, 4, 5, 6, 7, 8}));
  EXPECT_TRUE(switched.returned.empty());
  const auto hidden = [](const auto& records) {
    return std::ranges::count_if(records, [](const auto& record) { return record.isSetAside; });
  };
  EXPECT_EQ(hidden(entities.models()), 4);
  EXPECT_EQ(hidden(entities.links()), 6);
  EXPECT_EQ(hidden(entities.joints()), 5) << "the bridge, too";
  EXPECT_EQ(hidden(entities.collisions()), 6);
  EXPECT_EQ(hidden(entities.sensors()), 8);
  EXPECT_EQ(hidden(entities.lights()), 6 + 1);
  EXPECT_EQ(hidden(entities.actors()), 1);
  EXPECT_EQ(entities.findModel("b"), kNoSlot);
  EXPECT_EQ(entities.findModel("c::inner"), kNoSlot);
  EXPECT_EQ(entities.findLink("c::inner::tip"), kNoSlot);
  EXPECT_EQ(entities.findLight(kNoSlot, "sun"), kNoSlot);
  EXPECT_EQ(entities.findJoint(kNoSlot, "bridge"), kNoSlot);
  EXPECT_EQ(entities.slot(base), kNoSlot);
  EXPECT_TRUE(entities.isSetAside(base.value));
  EXPECT_TRUE(entities.isSetAside("c::inner"));
  EXPECT_FALSE(entities.isSetAside("a"));
  for (const char* name : {"b", "sun", "a", "lamp"}) EXPECT_TRUE(entities.isTaken(name)) << name;
  EXPECT_FALSE(entities.isTaken("walker"));
  // the slots are the same
  EXPECT_EQ(entities.models()[b].scopedName, "b");
  EXPECT_EQ(entities.models()[c].scopedName, "c");
  EXPECT_EQ(entities.links()[tip].description->name, "tip");
  // the remaining entities are unchanged
  const std::vector<std::string> now = roster(entities);
  std::size_t next = 0;
  for (const std::string& line : before) next += next < now.size() && now[next] == line ? 1 : 0;
  EXPECT_EQ(next, now.size());
}

TEST(SetAside, ReturnsWhatIsNoLongerListed) {
  const description::World world = shelfWorld();
  Entities entities(world);
  const std::vector<std::string> before = roster(entities);
  const std::vector<std::uint64_t> all = idsOf(entities, {"a", "b", "c", "d", "sun", "lamp", "walker", "runner"});
  const std::vector<std::uint64_t> two = idsOf(entities, {"a", "d", "sun", "runner"});
  entities.setAside(all);
  EXPECT_EQ(entities.listSetAside(), all);
  EXPECT_TRUE(roster(entities).empty());
  EXPECT_FALSE(entities.setAside(all).isAny);
  EXPECT_EQ(entities.setAside(two).returned, (std::vector<Slot>{3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(entities.listSetAside(), two);
  const Entities::Switched rest = entities.setAside({});
  EXPECT_EQ(rest.returned, (std::vector<Slot>{0, 1, 2, 9, 10, 11}));
  EXPECT_TRUE(rest.setAside.empty());
  EXPECT_EQ(roster(entities), before);
}

TEST(SetAside, KeepsWhatCameLaterBehind) {
  const description::World world = shelfWorld();
  Entities entities(world);
  entities.setAside(idsOf(entities, {"d"}));
  entities.insertModel(std::make_shared<description::Model>(shelfModel("late")));
  entities.setAside({});
  std::vector<std::string> names;
  for (const Slot slot : entities.topLevelModels()) names.push_back(entities.models()[slot].scopedName);
  EXPECT_EQ(names, (std::vector<std::string>{"a", "b", "c", "d", "late"}));
  roster(entities);
}

TEST(SetAside, KeepsItsReferencesWhileOthersGo) {
  const description::World world = shelfWorld();
  Entities entities(world), other(world);
  entities.setAside(idsOf(entities, {"b", "c", "d"}));
  for (Entities* each : {&entities, &other}) each->removeModel(each->findModel("a"));
  EXPECT_EQ(entities.setAside({}).returned.size(), 9U);
  EXPECT_EQ(roster(entities), roster(other));
}

TEST(SetAside, KeepsItsStateWhichCountsInTheHash) {
  const description::World world = shelfWorld();
  Entities entities(world);
  State state(entities);
  const std::uint64_t hash = stateHash(state);
  entities.setAside(idsOf(entities, {"a"}));
  EXPECT_EQ(stateHash(state), hash);
  state.links[0].v_WorldLink.x() = 1;
  EXPECT_NE(stateHash(state), hash);
}

}  // namespace
}  // namespace pongsim::world
