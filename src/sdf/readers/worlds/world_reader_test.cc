#include "support/sdf/load_support.hh"

namespace pongsim::sdf::test {
namespace {

TEST(World, ReadsLights) {
  const Loaded loaded = loadWorld(
      "<frame name='f'><pose>1 0 0 0 0 0</pose></frame>"
      "<light name='sun' type='directional'><pose relative_to='f'>0 0 10 0 0 0</pose></light>");
  EXPECT_EQ(loaded.messages, Messages());
  const description::Light& light = loaded.world().lights.at(0);
  EXPECT_EQ(light.name, "sun");
  EXPECT_EQ(light.type, description::LightType::kDirectional);
  expectPose(light.X_ParentLight, {1, 0, 10});
}

TEST(World, PlacesModelsInItsFrames) {
  const Loaded loaded = loadWorld(
      "<model name='a'><pose relative_to='f'>1 0 0 0 0 0</pose><link name='l'/></model>"
      "<model name='b'><pose relative_to='a::l'>0 1 0 0 0 0</pose><link name='l'/></model>"
      "<model name='c'><pose relative_to='world'>3 0 0 0 0 0</pose><link name='l'/></model>"
      "<frame name='f'><pose>0 0 5 0 0 0</pose></frame><frame name='g' attached_to='b'/>");
  EXPECT_EQ(loaded.messages, Messages());
  expectPose(loaded.world().models.at(0).X_ParentModel, {1, 0, 5});
  expectPose(loaded.world().models.at(1).X_ParentModel, {1, 1, 5});
  expectPose(loaded.world().models.at(2).X_ParentModel, {3, 0, 0});
  EXPECT_EQ(loaded.world().frames.at(0).attachedLink, "world");
  EXPECT_EQ(loaded.world().frames.at(1).attachedLink, "b::l");
  expectPose(loaded.world().frames.at(1).X_ModelFrame, {1, 1, 5});
}

TEST(World, JoinsModels) {
  const Loaded loaded = loadWorld(
      "<model name='a'><link name='l'/></model><model name='b'><pose>0 2 0 0 0 0</pose><link name='l'/></model>"
      "<joint name='j' type='fixed'><parent>a::l</parent><child>b::l</child></joint>"
      "<joint name='k' type='fixed'><parent>world</parent><child>a</child></joint>");
  EXPECT_EQ(loaded.messages, Messages());
  const auto& joints = loaded.world().joints;
  EXPECT_EQ(joints.at(0).parent, "a::l");
  EXPECT_EQ(joints.at(0).child, "b::l");
  expectPose(joints.at(0).X_ParentJoint, {0, 2, 0});
  EXPECT_EQ(joints.at(1).parent, "world");
  EXPECT_EQ(joints.at(1).child, "a::l");
}

TEST(World, HasModelsOfDifferentNames) {
  EXPECT_EQ(
      loadWorld("<model name='a'><link name='l'/></model>\n<model name='a'><link name='l'/></model>").messages,
      Messages{
          "t.sdf:3:1: error: model 'a' has the same name as another model of world 'w' | the first one is in line 2"});
}

TEST(World, NeedsAName) {
  EXPECT_EQ(load("<sdf version='1.9'><world/></sdf>").messages,
            Messages{"t.sdf:1:20: error: <world> has no name | write <world name=\"...\">"});
}

TEST(World, KeepsItsGuiAsItStands) {
  const Loaded loaded =
      loadWorld("<gui fullscreen='1'><camera name='c'/>\n<plugin filename='f' name='n'><x/></plugin></gui>");
  EXPECT_EQ(loaded.messages, Messages());
  ASSERT_TRUE(loaded.world().gui);
  EXPECT_EQ(loaded.world().gui->attributeOr("fullscreen", ""), "1");
  EXPECT_NE(loaded.world().gui->child("plugin")->child("x"), nullptr);
  EXPECT_EQ(loaded.world().gui->child("plugin")->position.line, 3);
  EXPECT_FALSE(loadWorld("").world().gui);
}

TEST(World, KeepsThePluginOfItsLevels) {
  const Loaded loaded = loadWorld(
      "<model name='m'><link name='l'/></model><plugin filename='dummy' name='ignition::gazebo'><level "
      "name='l'><geometry>"
      "<box/></geometry><ref>m</ref></level></plugin>");
  EXPECT_EQ(loaded.messages, Messages());
  EXPECT_EQ(loaded.world().plugins.at(0).sdf.child("level")->attributeOr("name", ""), "l");
  EXPECT_EQ(loaded.world().levels.levels.at(0).name, "l");
}

}  // namespace
}  // namespace pongsim::sdf::test
