// Entities that are set aside and restored.

#include <gtest/gtest.h>

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

/// Everything about the existing entities: ids, names and hierarchy.
std::vector<std::string> roster(const Entities& entities) {
  std::vector<std::string> lines;
  const auto link = [&](Slot slot) { return slot == kNoSlot ? "-" : std::to_string(entities.links()[slot].id.value); };
  for (const ModelRecord& model : entities.models()) {
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
  for (const LinkRecord& each : entities.links()) {
    std::string line = "link " + std::to_string(each.id.value) + " " + each.description->name + " of " +
                       entities.models()[each.model].scopedName;
    for (std::size_t i = 0; i < each.description->collisions.size(); ++i) {
      line += " " + std::to_string(entities.collisions()[each.firstCollision + i].id.value);
    }
    EXPECT_EQ(entities.slot(each.id), static_cast<Slot>(&each - entities.links().data()));
    lines.push_back(line);
  }
  for (const JointRecord& joint : entities.joints()) {
    lines.push_back("joint " + std::to_string(joint.id.value) + " " + link(joint.parentLink) + " " +
                    link(joint.childLink) + " of " +
                    (joint.model == kNoSlot ? "-" : entities.models()[joint.model].scopedName));
  }
  for (const CollisionRecord& collision : entities.collisions()) {
    lines.push_back("collision " + std::to_string(collision.id.value) + " " + link(collision.link));
  }
  for (const SensorRecord& sensor : entities.sensors()) {
    lines.push_back("sensor " + std::to_string(sensor.id.value) + " " + link(sensor.link) + " " +
                    (sensor.joint == kNoSlot ? "-" : std::to_string(entities.joints()[sensor.joint].id.value)));
  }
  for (const LightRecord& light : entities.lights()) {
    lines.push_back("light " + std::to_string(light.id.value) + " " + light.description->name + " " + link(light.link));
  }
  for (const ActorRecord& actor : entities.actors()) {
    lines.push_back("actor " + std::to_string(actor.id.value) + " " + actor.description->name);
  }
  for (const Slot slot : entities.topLevelModels()) lines.push_back("top " + entities.models()[slot].scopedName);
  return lines;
}

TEST(SetAside, TakesAGroupOutWithAllThatHangsOnIt) {
  const description::World world = shelfWorld();
  Entities entities(world);
  const std::vector<std::string> before = roster(entities);
  const Departure departure =
      entities.setAside({Roots{{entities.findModel("b"), entities.findModel("c")}, {}, {}}, Roots{{}, {8}, {0}}});
  EXPECT_EQ(departure.groups[0].models.size(), 4U);
  EXPECT_EQ(departure.groups[0].links.size(), 6U);
  EXPECT_EQ(departure.groups[0].joints.size(), 5U) << "the bridge, too";
  EXPECT_EQ(departure.groups[0].collisions.size(), 6U);
  EXPECT_EQ(departure.groups[0].sensors.size(), 8U);
  EXPECT_EQ(departure.groups[0].lights.size(), 6U);
  EXPECT_EQ(departure.slots.links[0], (std::vector<Slot>{3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(departure.slots.joints[0], (std::vector<Slot>{2, 3, 4, 5, 8}));
  EXPECT_TRUE(departure.slots.links[1].empty());
  EXPECT_EQ(departure.groups[1].actors.size(), 1U);
  EXPECT_EQ(entities.findModel("b"), kNoSlot);
  EXPECT_EQ(entities.findModel("c::inner"), kNoSlot);
  EXPECT_EQ(entities.slot(departure.groups[0].links[0].id), kNoSlot);
  EXPECT_EQ(entities.actors().size(), 1U);
  // the remaining entities are unchanged, and their references are right
  const std::vector<std::string> now = roster(entities);
  std::size_t next = 0;
  for (const std::string& line : before) next += next < now.size() && now[next] == line ? 1 : 0;
  EXPECT_EQ(next, now.size());
}

TEST(SetAside, BringsGroupsBackInAnyOrder) {
  const description::World world = shelfWorld();
  Entities entities(world);
  const std::vector<std::string> before = roster(entities);
  const auto groups = [&] {
    return std::vector<Roots>{{{entities.findModel("d")}, {}, {}},
                              {{entities.findModel("b"), entities.findModel("c")}, {}, {}},
                              {{entities.findModel("a")}, {entities.findLight(kNoSlot, "sun")}, {1}}};
  };
  Departure departure = entities.setAside(groups());
  EXPECT_TRUE(entities.models().empty());
  const GroupSlots first = entities.bringBack({departure.groups[1]});
  EXPECT_EQ(first.links[0], (std::vector<Slot>{0, 1, 2, 3, 4, 5}));
  const GroupSlots both = entities.bringBack({departure.groups[0], departure.groups[2]});
  EXPECT_EQ(both.links[0], (std::vector<Slot>{9, 10, 11}));
  EXPECT_EQ(both.links[1], (std::vector<Slot>{0, 1, 2}));
  EXPECT_EQ(both.joints[0], (std::vector<Slot>{6, 7}));
  EXPECT_EQ(roster(entities), before);
}

TEST(SetAside, KeepsWhatCameLaterBehind) {
  const description::World world = shelfWorld();
  Entities entities(world);
  Departure departure = entities.setAside({Roots{{entities.findModel("d")}, {}, {}}});
  entities.insertModel(std::make_shared<description::Model>(shelfModel("late")));
  entities.bringBack(std::move(departure.groups));
  std::vector<std::string> names;
  for (const Slot slot : entities.topLevelModels()) names.push_back(entities.models()[slot].scopedName);
  EXPECT_EQ(names, (std::vector<std::string>{"a", "b", "c", "d", "late"}));
  roster(entities);
}

TEST(SetAside, TakesTheStateAlong) {
  const description::World world = shelfWorld();
  Entities entities(world);
  State state(entities);
  for (Slot slot = 0; slot < state.links.size(); ++slot) {
    state.links[slot].X_WorldLink.position.x() = static_cast<double>(slot);
  }
  for (Slot slot = 0; slot < state.joints.size(); ++slot) state.joints[slot].position = static_cast<double>(slot);
  const std::uint64_t hash = stateHash(state);
  Departure departure =
      entities.setAside({Roots{{entities.findModel("b"), entities.findModel("c")}, {}, {}}, Roots{{0}, {}, {}}});
  std::vector<StatePart> parts = state.setAside(departure.slots);
  EXPECT_EQ(state.links.size(), 3U);
  EXPECT_EQ(state.links[0].X_WorldLink.position.x(), 9);
  EXPECT_EQ(parts[0].links[5].X_WorldLink.position.x(), 8);
  EXPECT_EQ(parts[0].joints[4].position, 8);
  // entities set aside are part of the hash
  const std::uint64_t without = stateHash(state, {&parts[0], &parts[1]});
  parts[1].links[0].v_WorldLink.x() = 1;
  EXPECT_NE(stateHash(state, {&parts[0], &parts[1]}), without);
  parts[1].links[0].v_WorldLink.x() = 0;
  const GroupSlots slots = entities.bringBack(std::move(departure.groups));
  state.bringBack(slots, std::move(parts));
  EXPECT_EQ(stateHash(state), hash);
}

}  // namespace
}  // namespace pongsim::world
