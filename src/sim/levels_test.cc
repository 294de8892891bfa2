// Loading and unloading of levels, as in Fortress's tests level_manager.cc and level_manager_runtime_performers.cc.

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/scene.hh"
#include "pongsim/sensing/beam_scene.hh"
#include "pongsim/sensing/sensor.hh"
#include "pongsim/simulation.hh"
#include "support/sim/level_world.hh"

namespace pongsim {
namespace {

using test::levelWorld;
using test::place;
using Names = std::vector<std::string>;

const Vector3 kNowhere(0, 0, 0);

class LevelsTest : public testing::Test {
 protected:
  explicit LevelsTest(const std::string& text = levelWorld())
      : simulation_(test::simulate(text, {.loadSystems = false, .levels = true})) {}

  void put(const char* model, const Vector3& position) {
    place(*simulation_, model, position);
    simulation_->step();
  }
  bool isThere(const std::string& model) { return simulation_->world().model(model).has_value(); }
  /// @return The names of the existing tiles.
  Names tiles() {
    Names names;
    for (const Model& model : simulation_->world().models()) {
      if (model.name().starts_with("tile")) names.emplace_back(model.name());
    }
    return names;
  }

  std::unique_ptr<Simulation> simulation_;
};

TEST_F(LevelsTest, HaveWhatIsInNoLevelAlwaysThere) {
  EXPECT_EQ(tiles(), Names{"tile_0"});
  EXPECT_TRUE(isThere("box"));
  EXPECT_TRUE(isThere("sphere"));
  EXPECT_EQ(Scene(simulation_->world()).lights().size(), 1U);
  simulation_->step(10);
  EXPECT_EQ(tiles(), Names{"tile_0"});
  EXPECT_EQ(simulation_->countSetAside(), 5U);
  std::vector<Performer> performers;
  simulation_->world().performers(performers);
  ASSERT_EQ(performers.size(), 2U);
  EXPECT_EQ(performers[0].name, "perf_box");
  EXPECT_EQ(performers[0].model, simulation_->world().model("box")->id());
  EXPECT_EQ(performers[0].size, Vector3(1, 1, 1));
  EXPECT_NE(performers[0].id, performers[1].id);
}

TEST_F(LevelsTest, LoadWhereAPerformerIsAndUnloadWhereNoneIs) {
  put("sphere", {40, 0, 0});
  EXPECT_EQ(tiles(), (Names{"tile_0", "tile_1"}));
  put("sphere", kNowhere);
  EXPECT_EQ(tiles(), Names{"tile_0"});
  // levels are updated while paused, too
  place(*simulation_, "sphere", {40, 0, 0});
  simulation_->stepPaused();
  EXPECT_EQ(tiles(), (Names{"tile_0", "tile_1"}));
}

TEST_F(LevelsTest, StayLoadedInTheirBuffer) {
  put("sphere", {40, 0, 0});
  put("sphere", {40, -20, 0});
  EXPECT_EQ(tiles(), (Names{"tile_0", "tile_1"})) << "out of the level, but in its buffer";
  put("sphere", {40, -20.6, 0});
  EXPECT_EQ(tiles(), Names{"tile_0"}) << "out of the buffer, with all of the performer's box";
  put("sphere", {40, -20, 0});
  EXPECT_EQ(tiles(), Names{"tile_0"}) << "in the buffer, from without";
  put("sphere", {40, -15.5, 0});
  EXPECT_EQ(tiles(), (Names{"tile_0", "tile_1"})) << "its box meets the level's";
}

TEST_F(LevelsTest, AreLoadedForEachPerformer) {
  const Vector3 level1(40, -10, 0), level2(40, 30, 0);
  for (const auto& [one, two] : {std::pair("sphere", "box"), std::pair("box", "sphere")}) {
    put(one, kNowhere);
    put(two, kNowhere);
    place(*simulation_, one, level1);
    put(two, level2);
    EXPECT_EQ(tiles(), (Names{"tile_0", "tile_1", "tile_2"}));
    put(one, kNowhere);
    EXPECT_EQ(tiles(), (Names{"tile_0", "tile_2"}));
    simulation_->step(100);
    EXPECT_EQ(tiles(), (Names{"tile_0", "tile_2"}));
    put(one, level2);
    EXPECT_EQ(tiles(), (Names{"tile_0", "tile_2"}));
    put(two, kNowhere);
    EXPECT_EQ(tiles(), (Names{"tile_0", "tile_2"})) << "the other one is still in it";
    put(one, kNowhere);
    EXPECT_EQ(tiles(), Names{"tile_0"});
  }
}

TEST_F(LevelsTest, StayLoadedWithAnyPerformerInTheirBuffer) {
  for (const auto& [one, two] : {std::pair("sphere", "box"), std::pair("box", "sphere")}) {
    place(*simulation_, one, {40, 0, 0});
    put(two, {40, -20, 0});
    EXPECT_EQ(tiles(), (Names{"tile_0", "tile_1"}));
    put(one, {40, -20, 0});
    EXPECT_EQ(tiles(), (Names{"tile_0", "tile_1"}));
    put(two, kNowhere);
    EXPECT_EQ(tiles(), (Names{"tile_0", "tile_1"}));
  }
}

TEST_F(LevelsTest, LetWhatIsSetAsideBeGoneForAllAndComeBackWithItsIds) {
  put("sphere", {40, 0, 0});
  const Model tile = simulation_->world().model("tile_1").value();
  const Collision collision = tile.links()[0].collisions()[0];
  EXPECT_FALSE(tile.isSetAside());
  put("sphere", kNowhere);
  EXPECT_FALSE(tile.exists());
  EXPECT_TRUE(tile.isSetAside());
  EXPECT_FALSE(collision.exists());
  EXPECT_TRUE(simulation_->isSetAside("tile_1"));
  EXPECT_FALSE(simulation_->isSetAside("tile_0"));
  EXPECT_FALSE(simulation_->isSetAside("none"));
  try {
    static_cast<void>(tile.pose());
    FAIL();
  } catch (const Gone& gone) {
    EXPECT_EQ(gone.what(),
              "the model with the id " + std::to_string(tile.id().value) + " is in a level that is not loaded");
  }
  put("sphere", {40, 0, 0});
  EXPECT_TRUE(tile.exists());
  EXPECT_EQ(tile.pose().position, Vector3(40, 0, 2.5));
  EXPECT_TRUE(collision.exists());
  EXPECT_EQ(collision.scopedName(), "tile_1::l::c");
}

TEST_F(LevelsTest, KeepWhereThingsWerePut) {
  // unlike Fortress, which creates the entities again at the pose in the file
  put("sphere", {40, 0, 0});
  place(*simulation_, "tile_1", {41, 1, 2.5});
  put("sphere", kNowhere);
  put("sphere", {40, 0, 0});
  EXPECT_EQ(simulation_->world().model("tile_1")->pose().position, Vector3(41, 1, 2.5));
}

TEST_F(LevelsTest, KeepTheirNames) {
  constexpr const char* kTile = "<sdf version='1.9'><model name='tile_1'><link name='l'/></model></sdf>";
  Diagnostics diagnostics;
  EXPECT_FALSE(simulation_->insertText(kTile, "t.sdf", {}, diagnostics));
  EXPECT_EQ(diagnostics.all().at(0).message, "there is a 'tile_1' in the world already");
  Diagnostics none;
  const auto inserted = simulation_->insertText(kTile, "t.sdf", {.allowRenaming = true}, none);
  ASSERT_TRUE(inserted);
  EXPECT_EQ(inserted->name(), "tile_1_0");
  // an inserted model is in no level, so it always exists; it comes last in the list
  put("sphere", {40, 0, 0});
  EXPECT_EQ(tiles(), (Names{"tile_0", "tile_1", "tile_1_0"}));
  put("sphere", kNowhere);
  EXPECT_EQ(tiles(), (Names{"tile_0", "tile_1_0"}));
}

TEST_F(LevelsTest, KeepWhatAJointHoldsToWhatStays) {
  put("sphere", {40, 0, 0});
  World world = simulation_->world();
  const Outcome<Joint> held = world.attach(world.model("box")->links()[0], world.model("tile_1")->links()[0]);
  ASSERT_TRUE(held);
  put("sphere", kNowhere);
  simulation_->step(10);
  EXPECT_EQ(tiles(), (Names{"tile_0", "tile_1"}));
  ASSERT_TRUE(world.detach(*held.value));
  simulation_->step();
  EXPECT_EQ(tiles(), Names{"tile_0"});
}

TEST_F(LevelsTest, LetJoinedModelsGoAndComeTogether) {
  put("sphere", {50, 10, 0});
  EXPECT_EQ(tiles(), (Names{"tile_0", "tile_1", "tile_2", "tile_4", "tile_5"}));
  World world = simulation_->world();
  const Outcome<Joint> held = world.attach(world.model("tile_1")->links()[0], world.model("tile_4")->links()[0]);
  ASSERT_TRUE(held);
  put("sphere", kNowhere);
  EXPECT_EQ(tiles(), Names{"tile_0"});
  EXPECT_FALSE(held.value->exists());
  put("sphere", {30, -10, 0});
  EXPECT_EQ(tiles(), (Names{"tile_0", "tile_1", "tile_4"}));
  EXPECT_TRUE(held.value->exists());
  EXPECT_EQ(held.value->child().scopedName(), "tile_4::l");
}

TEST_F(LevelsTest, AreWhatTheyWereAfterAReset) {
  const std::uint64_t start = simulation_->stateHash();
  put("sphere", {40, 0, 0});
  place(*simulation_, "tile_1", {41, 1, 2.5});
  EXPECT_TRUE(simulation_->addPerformer("tile_0"));
  put("sphere", {60, 0, 0});
  std::vector<Performer> performers;
  simulation_->world().performers(performers);
  EXPECT_EQ(performers.size(), 3U);
  const std::uint64_t id = performers[0].id;
  Diagnostics diagnostics;
  simulation_->reset(diagnostics);
  EXPECT_EQ(tiles(), Names{"tile_0"});
  EXPECT_EQ(simulation_->stateHash(), start);
  simulation_->world().performers(performers);
  ASSERT_EQ(performers.size(), 2U);
  EXPECT_EQ(performers[0].id, id);
  put("sphere", {40, 0, 0});
  EXPECT_EQ(simulation_->world().model("tile_1")->pose().position, Vector3(40, 0, 2.5));
}

TEST_F(LevelsTest, GoOnWhereAPerformerIsRemoved) {
  put("sphere", {40, 0, 0});
  ASSERT_TRUE(simulation_->remove(*simulation_->world().model("sphere")));
  simulation_->step();
  EXPECT_EQ(tiles(), Names{"tile_0"}) << "nobody is near";
  std::vector<Performer> performers;
  simulation_->world().performers(performers);
  EXPECT_EQ(performers.size(), 1U);
  put("box", {40, 0, 0});
  ASSERT_TRUE(simulation_->remove(*simulation_->world().model("tile_1")));
  put("box", kNowhere);
  put("box", {40, 0, 0});
  EXPECT_EQ(tiles(), Names{"tile_0"}) << "it was removed, and stays so";
}

TEST_F(LevelsTest, AreNotInTheMessagesOfTheScene) {
  const auto hasTile = [&] {
    const MessagePointer scene = newMessage("ignition.msgs.Scene"),
                         state = newMessage("ignition.msgs.SerializedStepMap");
    Scene(simulation_->world()).fillIn(*scene);
    Scene(simulation_->world()).fillInState(*state, StateContent::kAll, false);
    const bool isInScene = messageText(*scene).find("tile_1") != std::string::npos;
    EXPECT_EQ(messageText(*state).find("tile_1") != std::string::npos, isInScene);
    EXPECT_EQ(Scene(simulation_->world()).graph().find("tile_1") != std::string::npos, isInScene);
    return isInScene;
  };
  EXPECT_FALSE(hasTile());
  put("sphere", {40, 0, 0});
  EXPECT_TRUE(hasTile());
  put("sphere", kNowhere);
  EXPECT_FALSE(hasTile());
}

class RuntimePerformers : public LevelsTest {
 protected:
  RuntimePerformers() : LevelsTest(levelWorld(false)) {}
};

TEST_F(RuntimePerformers, MakeLevelsComeAndGo) {
  place(*simulation_, "sphere", {40, 0, 0});
  simulation_->step();
  EXPECT_EQ(tiles(), Names{"tile_0"}) << "it does not perform yet";
  EXPECT_TRUE(simulation_->addPerformer("sphere"));
  EXPECT_EQ(simulation_->addPerformer("sphere").error, "model 'sphere' is already a performer");
  EXPECT_EQ(simulation_->addPerformer("").error, "no model is given");
  simulation_->step();
  EXPECT_EQ(tiles(), (Names{"tile_0", "tile_1"}));
  std::vector<Performer> performers;
  simulation_->world().performers(performers);
  ASSERT_EQ(performers.size(), 1U);
  EXPECT_EQ(performers[0].name, "perf_sphere");
  EXPECT_EQ(performers[0].size, Vector3(2, 2, 2));
  put("sphere", kNowhere);
  EXPECT_EQ(tiles(), Names{"tile_0"});
}

TEST_F(RuntimePerformers, MayBeNamedBeforeTheyAreThere) {
  EXPECT_TRUE(simulation_->addPerformer("late"));
  simulation_->step(10);
  Diagnostics diagnostics;
  ASSERT_TRUE(
      simulation_->insertText("<sdf version='1.9'><model name='late'><pose>40 0 0 0 0 0</pose><link name='l'/>"
                              "</model></sdf>",
                              "t.sdf", {}, diagnostics));
  simulation_->step();
  EXPECT_EQ(tiles(), (Names{"tile_0", "tile_1"}));
}

TEST_F(RuntimePerformers, HaveASizeAndAreModelsOfTheTopLevel) {
  World world = simulation_->world();
  const Model sphere = *world.model("sphere");
  const std::string refusal = "the size of a performer must be three numbers above zero";
  EXPECT_EQ(world.addPerformer(sphere, {1, 0, 1}).error, refusal);
  EXPECT_EQ(world.addPerformer(sphere, {1, std::numeric_limits<double>::quiet_NaN(), 1}).error, refusal);
  EXPECT_TRUE(world.addPerformer(sphere, {1, 1, 1}, "p"));
  EXPECT_EQ(world.addPerformer(sphere, {1, 1, 1}, "q").error, "model 'sphere' is already a performer");
  ASSERT_TRUE(simulation_->remove(*world.model("box")));
  EXPECT_TRUE(simulation_->addPerformer("box")) << "when it is there";
}

TEST(Levels, AreAllThereWithoutTheOption) {
  const auto simulation = test::simulate(levelWorld(), {.loadSystems = false});
  simulation->step();
  EXPECT_EQ(simulation->world().models().size(), 8U);
  EXPECT_EQ(simulation->countSetAside(), 0U);
  std::vector<Performer> performers;
  simulation->world().performers(performers);
  EXPECT_EQ(performers.size(), 2U) << "for who wants to know";
}

TEST(Levels, AreWarnedOfWhereThereAreNone) {
  Diagnostics diagnostics;
  EXPECT_NE(Simulation::fromText("<sdf version='1.9'><world name='w'/></sdf>", "t.sdf",
                                 {.loadSystems = false, .levels = true}, diagnostics),
            nullptr);
  ASSERT_EQ(diagnostics.all().size(), 1U);
  EXPECT_EQ(format(diagnostics.all()[0]),
            "t.sdf:1:20: warning: world 'w' has no levels: all of it is loaded\n  hint: add them in a <plugin "
            "filename=\"dummy\" name=\"gz::sim\"> of the world");
}

TEST(Levels, HaveLightsAndActorsToo) {
  const std::string more =
      "<light name='lamp' type='point'/><actor name='walker'><link name='l'><visual "
      "name='v'><geometry><sphere><radius>1"
      "</radius></sphere></geometry></visual></link></actor><actor name='runner'><link name='l'/></actor>";
  std::string text = levelWorld(true, more);
  text.replace(text.find("<ref>tile_1</ref>"), 17, "<ref>tile_1</ref><ref>lamp</ref><ref>walker</ref>");
  const auto simulation = test::simulate(text, {.loadSystems = false, .levels = true});
  const auto isThere = [&](const char* name) {
    const MessagePointer state = newMessage("ignition.msgs.SerializedStepMap");
    Scene(simulation->world()).fillInState(*state, StateContent::kAll, false);
    return messageText(*state).find(name) != std::string::npos;
  };
  EXPECT_FALSE(isThere("lamp"));
  EXPECT_FALSE(isThere("walker"));
  EXPECT_TRUE(isThere("runner"));
  place(*simulation, "box", {40, 0, 0});
  simulation->step();
  EXPECT_TRUE(isThere("lamp"));
  EXPECT_TRUE(isThere("walker"));
  const std::vector<LightPlace> lights = Scene(simulation->world()).lights();
  ASSERT_EQ(lights.size(), 2U);
  EXPECT_EQ(lights[1].name, "lamp");
}

TEST(Levels, AreLoadedByActors) {
  const std::string walker =
      "<actor name='walker'><script><loop>false</loop><trajectory id='0' type='t'><waypoint><time>0</time><pose>0 0 0 "
      "0 "
      "0 0</pose></waypoint><waypoint><time>1</time><pose>40 0 0 0 0 0</pose></waypoint></trajectory></script></actor>";
  std::string text = levelWorld(false, walker);
  text.replace(text.find("<level "), 7, test::performerText("walker") + "<level ");
  const auto simulation = test::simulate(text, {.loadSystems = false, .levels = true});
  simulation->step();
  EXPECT_FALSE(simulation->world().model("tile_1"));
  simulation->step(1000);
  EXPECT_TRUE(simulation->world().model("tile_1"));
}

// A wall that is far away from its level, and a ball that flies towards the wall.
const std::string kWall =
    "<model name='wall'><static>true</static><pose>0 50 0 0 0 0</pose><link name='l'><collision "
    "name='c'><geometry><box>"
    "<size>9 1 9</size></box></geometry></collision><visual name='v'><geometry><box><size>9 1 9</size></box></geometry>"
    "</visual></link></model><model name='ball'><pose>0 45 0 0 0 0</pose><link name='l'><inertial><mass>1</mass>"
    "</inertial><collision name='c'><geometry><sphere><radius>0.5</radius></sphere></geometry></collision>"
    "<sensor name='eye' type='gpu_lidar'/></link></model>";

std::unique_ptr<Simulation> wallWorld() {
  std::string text = levelWorld(true, kWall);
  text.replace(text.find("<ref>tile_1</ref>"), 17, "<ref>wall</ref>");
  return test::simulate(text, {.loadSystems = false, .levels = true});
}

TEST(Levels, TouchNothingWhileTheyAreNotLoaded) {
  for (const bool isLoaded : {false, true}) {
    const auto simulation = wallWorld();
    if (isLoaded) place(*simulation, "box", {40, 0, 0});
    simulation->step();
    simulation->world().model("ball")->setVelocity({0, 5, 0}, {0, 0, 0});
    simulation->step(2000);
    const double y = simulation->world().model("ball")->pose().position.y();
    EXPECT_NEAR(y, isLoaded ? 49 : 55, 0.1);
  }
}

TEST(Levels, AreNotSeenWhileTheyAreNotLoaded) {
  const auto simulation = wallWorld();
  BeamScene scene(simulation->world());
  const auto range = [&] {
    Diagnostics diagnostics;
    scene.rebuild(diagnostics);
    scene.update();
    const Vector3 ahead = Vector3::UnitY();
    Echo echo;
    scene.cast(simulation->world().sensors("gpu_lidar").at(0), {&ahead, 1}, 0, 100, 0xFFFFFFFF, {&echo, 1});
    return echo.range;
  };
  EXPECT_EQ(range(), std::numeric_limits<double>::infinity());
  place(*simulation, "box", {40, 0, 0});
  simulation->step();
  EXPECT_EQ(range(), 4.5);
  place(*simulation, "box", {0, 0, 0});
  simulation->step();
  EXPECT_EQ(range(), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace pongsim
