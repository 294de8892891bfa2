#include "msgs/state/visible_world.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/serialized_map.pb.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <variant>

#include "msgs/state/component.hh"
#include "msgs/state/state_message.hh"
#include "support/msgs/scene_support.hh"
#include "support/temp_folder.hh"

namespace pongsim::msgs {
namespace {

description::World throughAState(const description::World& world, Diagnostics& diagnostics) {
  const world::Entities entities(world);
  ignition::msgs::SerializedStepMap step;
  setState(entities, world::State(entities), StateContent::kAll, false, step);
  return visibleWorld(step, diagnostics);
}

TEST(VisibleWorld, IsThatOfTheState) {
  description::World world = test::cartWorld();
  world.scene.background = {0.25F, 0.5F, 1, 1};
  world.scene.hasShadows = false;
  world.scene.sky.emplace().time = 12.5;
  world.lights[0].isOn = false;
  description::Visual& look = world.models[1].links[0].visuals[0];
  look.transparency = 0.25;
  look.castsShadows = false;
  look.visibilityFlags = 0xF0F0F0F0;
  look.laserRetro = 7.5;
  const world::Entities entities(world);
  world::State state(entities);
  state.links[entities.findLink("cart::base")].X_WorldLink = {{5, 6, 7}, fromRollPitchYaw(0.1, 0.2, 0.3)};
  ignition::msgs::SerializedStepMap step;
  setState(entities, state, StateContent::kAll, false, step);

  Diagnostics diagnostics;
  const description::World seen = visibleWorld(step, diagnostics);
  EXPECT_TRUE(diagnostics.all().empty());
  EXPECT_EQ(seen.name, "w");
  EXPECT_EQ(seen.scene, world.scene);
  ASSERT_EQ(seen.lights.size(), 1U);
  EXPECT_EQ(seen.lights[0].name, "sun");
  EXPECT_FALSE(seen.lights[0].isOn);
  ASSERT_EQ(seen.models.size(), 2U);
  ASSERT_EQ(seen.models[1].links.size(), 1U);
  const description::Link& base = seen.models[1].links[0];
  ASSERT_EQ(base.visuals.size(), 1U);
  EXPECT_EQ(base.visuals[0], look);
  ASSERT_EQ(base.lights.size(), 1U);
  EXPECT_TRUE(base.lights[0].isOn);

  const world::Entities again(seen);
  const world::State started(again);
  for (const char* name : {"ground::l", "cart::base", "cart::arm::tip"}) {
    ASSERT_NE(again.findLink(name), world::kNoSlot) << name;
    EXPECT_TRUE(started.links[again.findLink(name)].X_WorldLink.position.isApprox(
        state.links[entities.findLink(name)].X_WorldLink.position))
        << name;
  }
}

TEST(VisibleWorld, LooksTheSameWhereOnlyLinksHaveMoved) {
  const auto stepOf = [](const description::World& world, const Vector3& position) {
    const world::Entities entities(world);
    world::State state(entities);
    state.links[entities.findLink("cart::base")].X_WorldLink.position = position;
    ignition::msgs::SerializedStepMap step;
    setState(entities, state, StateContent::kAll, false, step);
    return step;
  };
  const description::World world = test::cartWorld();
  const ignition::msgs::SerializedStepMap step = stepOf(world, {1, 2, 3});
  EXPECT_TRUE(haveSameLooks(step, step));
  EXPECT_TRUE(haveSameLooks(step, stepOf(world, {3, 2, 1})));

  description::World other = world;
  other.models[1].links[0].visuals[0].transparency = 0.25;
  EXPECT_FALSE(haveSameLooks(step, stepOf(other, {1, 2, 3})));
  other = world;
  other.models[1].links[0].visuals[0].X_LinkVisual.position.x() += 1;
  EXPECT_FALSE(haveSameLooks(step, stepOf(other, {1, 2, 3})));
  other = world;
  other.models.erase(other.models.begin());
  EXPECT_FALSE(haveSameLooks(step, stepOf(other, {1, 2, 3})));
}

TEST(VisibleWorld, FindsTheFilesOfMeshesAndTextures) {
  const test::TempFolder folder;
  description::World world = test::cartWorld();
  description::Visual& look = world.models[1].links[0].visuals[0];
  description::Mesh cup;
  cup.uri = "model://cup.dae";
  cup.file = folder.write("cup.dae", "");
  look.geometry = cup;
  description::PbrMetal& metal = look.material.emplace().metal.emplace();
  metal.maps.albedo = {"wood.png", folder.write("wood.png", "")};
  const description::Texture bumps{"bumps.png", folder.write("bumps.png", "")};
  metal.maps.normal = metal.maps.emissive = metal.roughnessMap = metal.metalnessMap = bumps;
  Diagnostics diagnostics;
  const description::World seen = throughAState(world, diagnostics);
  EXPECT_TRUE(diagnostics.all().empty());
  const description::Visual& found = seen.models[1].links[0].visuals[0];
  EXPECT_EQ(std::get<description::Mesh>(found.geometry).file, folder.path() / "cup.dae");
  const description::PbrMetal& foundMetal = *found.material->metal;
  EXPECT_EQ(foundMetal.maps.albedo.file, folder.path() / "wood.png");
  for (const description::Texture* texture :
       {&foundMetal.maps.normal, &foundMetal.maps.emissive, &foundMetal.roughnessMap, &foundMetal.metalnessMap}) {
    EXPECT_EQ(texture->file, bumps.file);
  }

  // each file once, however often it is used
  world.models[0].links[0].visuals = {look};
  std::filesystem::remove(folder.path() / "cup.dae");
  std::filesystem::remove(folder.path() / "wood.png");
  const description::World poorer = throughAState(world, diagnostics);
  EXPECT_TRUE(std::get<description::Mesh>(poorer.models[1].links[0].visuals[0].geometry).file.empty());
  ASSERT_EQ(diagnostics.all().size(), 2U);
  for (const auto& [number, name] : {std::pair(0, "mesh '"), std::pair(1, "texture '")}) {
    const Diagnostic& said = diagnostics.all()[static_cast<std::size_t>(number)];
    EXPECT_EQ(said.severity, Severity::kWarning);
    EXPECT_TRUE(said.message.starts_with(name + (folder.path() / "").string())) << said.message;
    EXPECT_NE(said.hint.find("PONGSIM_RESOURCE_PATH"), std::string::npos);
  }
}

TEST(VisibleWorld, HasItsPolylinesFilledAgain) {
  description::World world = test::cartWorld();
  description::Polyline triangle;
  triangle.lines = {{{0, 0}, {1, 0}, {0, 2}}};
  world.models[1].links[0].visuals[0].geometry = triangle;
  Diagnostics diagnostics;
  const description::World seen = throughAState(world, diagnostics);
  const auto& polyline = std::get<description::Polyline>(seen.models[1].links[0].visuals[0].geometry);
  EXPECT_EQ(polyline, triangle);
  EXPECT_NE(polyline.triangles, nullptr);
}

TEST(VisibleWorld, HasActorsWhereTheyWereMoved) {
  description::World world;
  description::Actor& actor = world.actors.emplace_back();
  actor.name = "walker";
  actor.X_WorldActor.position = {1, 2, 3};
  actor.trajectories.emplace_back().waypoints = {{0, {}}, {2, {{4, 0, 0}, Quaternion::Identity()}}};
  const world::Entities entities(world);
  world::State state(entities);
  state.actors.push_back({&actor, {{7, 8, 9}, fromRollPitchYaw(0, 0, 0.5)}, "walk", Time(0)});
  ignition::msgs::SerializedStepMap step;
  setState(entities, state, StateContent::kAll, false, step);
  Diagnostics diagnostics;
  const description::World seen = visibleWorld(step, diagnostics);
  ASSERT_EQ(seen.actors.size(), 1U);
  EXPECT_TRUE(seen.actors[0].trajectories.empty());
  EXPECT_NEAR((seen.actors[0].X_WorldActor.position - Vector3(7, 8, 9)).norm(), 0, 1e-9);
  EXPECT_NEAR(yawOf(seen.actors[0].X_WorldActor.rotation), 0.5, 1e-9);
}

TEST(VisibleWorld, HasItsActors) {
  description::World world = test::cartWorld();
  description::Actor& actor = world.actors.emplace_back();
  actor.name = "walker";
  actor.X_WorldActor.position = {1, 2, 3};
  actor.trajectories.emplace_back().waypoints = {{0, {}}, {2, {{4, 0, 0}, Quaternion::Identity()}}};
  description::Visual& look = actor.visuals.emplace_back();
  look.name = "look";
  look.geometry = description::Sphere{0.5};
  Diagnostics diagnostics;
  EXPECT_EQ(throughAState(world, diagnostics).actors, world.actors);
  // an actor whose skin is missing
  actor.skin.uri = "/no/such/walk.dae";
  EXPECT_TRUE(throughAState(world, diagnostics).actors.at(0).skin.file.empty());
  ASSERT_EQ(diagnostics.all().size(), 1U);
  EXPECT_TRUE(diagnostics.all()[0].message.starts_with("skin '/no/such/walk.dae' is not on this machine"));
}

TEST(VisibleWorld, LeavesOutWhatItCanNotRead) {
  ignition::msgs::SerializedStepMap step;
  const auto set = [&step](std::uint64_t id, const char* name, const std::string& bytes) {
    auto& components = *(*step.mutable_state()->mutable_entities())[id].mutable_components();
    components[static_cast<std::int64_t>(componentType(name))].set_component(bytes);
  };
  Diagnostics diagnostics;
  EXPECT_TRUE(visibleWorld(step, diagnostics).models.empty());
  set(1, "World", "");
  set(2, "Model", "");
  set(2, "ParentEntity", "1");
  set(2, "Pose", "nan 0 0 0 0 0");
  set(3, "Link", "");
  set(3, "ParentEntity", "2");
  set(4, "Visual", "");
  set(4, "ParentEntity", "3");
  set(4, "Geometry", "\xff no such thing");
  set(5, "Model", "");
  set(5, "ParentEntity", "no number");
  const description::World seen = visibleWorld(step, diagnostics);
  ASSERT_EQ(seen.models.size(), 1U);
  EXPECT_EQ(seen.models[0].X_ParentModel.position, Vector3::Zero().eval());
  ASSERT_EQ(seen.models[0].links.size(), 1U);
  ASSERT_EQ(seen.models[0].links[0].visuals.size(), 1U);
  EXPECT_TRUE(std::holds_alternative<description::Empty>(seen.models[0].links[0].visuals[0].geometry));
}

}  // namespace
}  // namespace pongsim::msgs
