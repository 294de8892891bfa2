#include "pongsim/scene.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/light.pb.h>
#include <ignition/msgs/scene.pb.h>
#include <ignition/msgs/serialized_map.pb.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "pongsim/simulation.hh"

namespace pongsim::scene_test {
namespace {

class SceneTest : public testing::Test {
 protected:
  SceneTest() {
    Diagnostics diagnostics;
    simulation_ = Simulation::fromText(
        "<sdf version='1.9'><world name='w'><gravity>0 0 0</gravity>"
        "<model name='box'><link name='l'><light name='lamp' type='point'><pose>0 0 1 0 0 "
        "0</pose></light></link></model>"
        "<light name='sun' type='directional'/></world></sdf>",
        "world.sdf", {.loadSystems = false}, diagnostics);
    EXPECT_FALSE(diagnostics.hasErrors());
  }

  ignition::msgs::Light sun(double range) const {
    ignition::msgs::Light message;
    message.set_name("sun");
    message.set_range(static_cast<float>(range));
    return message;
  }

  std::unique_ptr<Simulation> simulation_;
};

TEST_F(SceneTest, KnowsLightsAndWhoIsAtTheTop) {
  const Scene scene(simulation_->world());
  const std::vector<LightPlace> lights = scene.lights();
  ASSERT_EQ(lights.size(), 2U);
  EXPECT_EQ(lights[0].name, "lamp");
  EXPECT_EQ(lights[0].X_ParentLight.position, Vector3(0, 0, 1));
  EXPECT_EQ(lights[1].name, "sun");
  EXPECT_EQ(scene.topLevelIds(),
            (std::vector<std::uint64_t>{simulation_->world().model("box")->id().value, lights[1].id.value}));
}

TEST_F(SceneTest, KnowsActors) {
  Diagnostics diagnostics;
  const auto simulation = Simulation::fromText(
      "<sdf version='1.9'><world name='w'><actor name='walker'><skin><filename>nowhere.dae</filename></skin></actor>"
      "<actor name='box'><link name='l'/></actor></world></sdf>",
      "world.sdf", {.loadSystems = false}, diagnostics);
  ASSERT_TRUE(simulation);
  const std::vector<ActorPlace> actors = Scene(simulation->world()).actors();
  ASSERT_EQ(actors.size(), 2U);
  EXPECT_EQ(actors[0].name, "walker");
  EXPECT_EQ(actors[0].skin, "nowhere.dae");
  EXPECT_EQ(actors[1].name, "box");
  EXPECT_EQ(actors[1].skin, "");
  EXPECT_NE(actors[0].id.value, actors[1].id.value);
}

TEST_F(SceneTest, FollowsWhatComesAndGoes) {
  const Scene scene(simulation_->world());
  EXPECT_FALSE(simulation_->insertLight(sun(1), {})) << "there is one already";
  const Outcome<std::string> moon = simulation_->insertLight(sun(1), {.name = "moon"});
  ASSERT_TRUE(moon);
  EXPECT_EQ(*moon.value, "moon");
  EXPECT_EQ(scene.topLevelIds().size(), 3U);
  EXPECT_TRUE(simulation_->removeLight({}, "sun"));
  EXPECT_FALSE(simulation_->removeLight(scene.lights()[0].id, "")) << "it is a part of a link";
  EXPECT_EQ(scene.topLevelIds().size(), 2U);
  Diagnostics diagnostics;
  simulation_->reset(diagnostics);
  EXPECT_EQ(scene.lights().back().name, "sun");
}

TEST_F(SceneTest, TellsALightAsItWasChanged) {
  ignition::msgs::Scene message;
  EXPECT_TRUE(simulation_->changeLight(sun(7)));
  Scene(simulation_->world()).fillIn(message);
  ASSERT_EQ(message.light_size(), 1);
  EXPECT_EQ(message.light(0).range(), 7);
  EXPECT_FALSE(simulation_->changeLight(sun(-7)));
  ignition::msgs::Light lamp = sun(3);
  lamp.set_name("lamp");
  EXPECT_FALSE(simulation_->changeLight(lamp)) << "it is not the world's";
  lamp.set_parent_id(static_cast<std::uint32_t>(simulation_->world().model("box")->link("l")->id().value));
  EXPECT_TRUE(simulation_->changeLight(lamp));
  Scene(simulation_->world()).fillIn(message);
  EXPECT_EQ(message.model(0).link(0).light(0).range(), 3);
}

TEST_F(SceneTest, TellsTheStateOfWhatMoves) {
  ignition::msgs::SerializedStepMap message;
  Scene(simulation_->world()).fillInState(message, StateContent::kMoving, true);
  EXPECT_TRUE(message.stats().paused());
  EXPECT_EQ(message.state().entities_size(), 2);
}

}  // namespace
}  // namespace pongsim::scene_test
