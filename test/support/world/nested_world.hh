#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

#include "world/entities.hh"

namespace pongsim::world {

inline description::Link link(std::string name, double x = 0) {
  description::Link result;
  result.name = std::move(name);
  result.X_ModelLink.position.x() = x;
  return result;
}

/// outer { base, arm; joint; inner { tip } }, then lone { base }, then a joint between the two.
inline description::World nestedWorld() {
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

/// Expects that every record leads to what it led to, whatever slots have gone.
inline void expectWhole(const Entities& entities) {
  for (Slot slot = 0; slot < entities.models().size(); ++slot) {
    const ModelRecord& model = entities.models()[slot];
    EXPECT_EQ(entities.findModel(model.scopedName), slot);
    for (const Slot link : model.links) EXPECT_EQ(entities.links()[link].model, slot);
    for (const Slot joint : model.joints) EXPECT_EQ(entities.joints()[joint].model, slot);
    for (const Slot inner : model.models) EXPECT_EQ(entities.models()[inner].parent, slot);
  }
  for (Slot slot = 0; slot < entities.collisions().size(); ++slot) {
    const LinkRecord& link = entities.links()[entities.collisions()[slot].link];
    EXPECT_EQ(&link.description->collisions[slot - link.firstCollision], entities.collisions()[slot].description);
    EXPECT_EQ(entities.slot(entities.collisions()[slot].id), slot);
  }
  const auto expectLink = [&](Slot holder, Slot slot, const std::string& name) {
    EXPECT_EQ(slot, name == "world" ? kNoSlot : entities.findLink(holder, name)) << name;
  };
  for (Slot slot = 0; slot < entities.joints().size(); ++slot) {
    const JointRecord& joint = entities.joints()[slot];
    EXPECT_EQ(entities.slot(joint.id), slot);
    expectLink(joint.model, joint.parentLink, joint.description->parent);
    expectLink(joint.model, joint.childLink, joint.description->child);
  }
  for (Slot slot = 0; slot < entities.sensors().size(); ++slot) {
    const SensorRecord& sensor = entities.sensors()[slot];
    EXPECT_EQ(entities.slot(sensor.id), slot);
    const auto& sensors = sensor.link != kNoSlot ? entities.links()[sensor.link].description->sensors
                                                 : entities.joints()[sensor.joint].description->sensors;
    EXPECT_TRUE(std::ranges::any_of(sensors, [&](const auto& each) { return &each == sensor.description; }));
  }
  for (Slot slot = 0; slot < entities.lights().size(); ++slot) {
    const LightRecord& light = entities.lights()[slot];
    EXPECT_EQ(entities.slot(light.id), slot);
    if (light.link == kNoSlot) continue;
    const auto& lights = entities.links()[light.link].description->lights;
    EXPECT_TRUE(std::ranges::any_of(lights, [&](const auto& each) { return &each == light.description; }));
  }
}

}  // namespace pongsim::world
